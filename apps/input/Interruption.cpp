// SPDX-License-Identifier: BSD-3-Clause
#include "Interruption.h"

#include <atomic>

namespace offmap::app {

namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a handler knows nothing else
std::atomic<bool> arrived{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a handler may not wait");

}  // namespace

Interruption::Interruption() {
    arrived = false;
    struct sigaction remember {};
    remember.sa_handler = [](int) { arrived = true; };
    for (size_t i = 0; i < watched.size(); ++i) {
        sigaction(watched[i], nullptr, &before_[i]);
        // What the program was told to ignore (nohup) stays ignored.
        if (before_[i].sa_handler != SIG_IGN) sigaction(watched[i], &remember, nullptr);
    }
}

Interruption::~Interruption() {
    for (size_t i = 0; i < watched.size(); ++i) sigaction(watched[i], &before_[i], nullptr);
}

bool Interruption::came() const { return arrived; }

}  // namespace offmap::app
