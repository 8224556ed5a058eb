// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedMemory.h"

#include <offmap/rawlog/GuardedRun.h>

#include <cstring>
#include <stdexcept>
#include <unistd.h>

namespace offmap::rawlog {

void GuardedStatus::atEntry(const EntryPlace& place) {
    memory_.index = place.index;
    memory_.offset = place.offset;
    memory_.hasPlace = true;
}

void GuardedStatus::beginPublishing() {
    int expected = GuardedMemory::Working;
    if (memory_.phase.compare_exchange_strong(expected, GuardedMemory::Publishing)) return;
    if (expected == GuardedMemory::Publishing) return;
    for (;;) pause();  // the watcher is about to kill this program
}

void GuardedStatus::add(const std::filesystem::path& file) {
    const std::scoped_lock lock(mutex_);
    const std::string path = std::filesystem::absolute(file).string();
    for (GuardedMemory::Temporary& slot : memory_.temporaries) {
        if (slot.used) continue;
        if (path.size() >= slot.path.size()) throw std::length_error(path + ": name too long");
        std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
        slot.used = true;
        return;
    }
    throw std::length_error("too many temporary files at once");
}

void GuardedStatus::remove(const std::filesystem::path& file) {
    const std::scoped_lock lock(mutex_);
    const std::string path = std::filesystem::absolute(file).string();
    for (GuardedMemory::Temporary& slot : memory_.temporaries) {
        if (slot.used && path == slot.path.data()) slot.used = false;
    }
}

}  // namespace offmap::rawlog
