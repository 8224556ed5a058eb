// SPDX-License-Identifier: BSD-3-Clause
#include "Handover.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <sys/mman.h>
#include <system_error>

namespace offmap::app {

/// Takes no more memory than what is put into it.
struct Handover::Shared {
    std::atomic<size_t> size;
    std::array<uint8_t, size_t{1} << 22> bytes;
};

Handover::Handover() : shared_(nullptr, [](Shared* shared) { munmap(shared, sizeof(Shared)); }) {
    void* memory =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        throw std::system_error(errno, std::generic_category(), "cannot get shared memory");
    }
    shared_.reset(new (memory) Shared);  // not {}: it is zero, and to write it would take memory
}

void Handover::put(std::span<const uint8_t> bytes) {
    if (bytes.size() > shared_->bytes.size()) throw std::length_error("too much to hand over");
    std::copy(bytes.begin(), bytes.end(), shared_->bytes.begin());
    shared_->size = bytes.size();
}

std::span<const uint8_t> Handover::content() const {
    return {shared_->bytes.data(), shared_->size};
}

}  // namespace offmap::app
