// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/EntryPlace.h>

#include <array>
#include <atomic>

namespace offmap::rawlog {

/// Memory shared by the guarded work and its watcher. Holds no pointer.
struct GuardedMemory {
    enum Phase : int { Working, Publishing, Stopped };

    struct Temporary {
        std::atomic<bool> used;
        std::array<char, 4096> path;  // PATH_MAX
    };

    std::atomic<int> phase;
    std::atomic<bool> finished;  ///< the work returned: its exit code is its own
    std::atomic<bool> threw;
    std::array<char, 1024> message;  ///< of what it threw
    std::atomic<bool> hasPlace;
    std::atomic<uint64_t> index, offset;
    std::array<Temporary, 8> temporaries;
};

static_assert(std::atomic<uint64_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

}  // namespace offmap::rawlog
