// SPDX-License-Identifier: BSD-3-Clause
#include "Handover.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <sys/mman.h>
#include <system_error>

namespace offmap::app {

/// What is handed over follows behind it.
struct Handover::Shared {
    std::atomic<size_t> size;

    uint8_t* bytes() { return reinterpret_cast<uint8_t*>(this + 1); }
};

void Handover::Unmap::operator()(Shared* shared) const { munmap(shared, size); }

Handover::Handover(size_t capacity)
    : capacity_(capacity), shared_(nullptr, Unmap{sizeof(Shared) + capacity}) {
    void* memory = mmap(nullptr, sizeof(Shared) + capacity, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) {
        throw std::system_error(errno, std::generic_category(), "cannot get shared memory");
    }
    shared_.reset(new (memory) Shared{});
}

void Handover::put(std::span<const uint8_t> bytes) {
    if (bytes.size() > capacity_) throw std::length_error("too much to hand over");
    std::copy(bytes.begin(), bytes.end(), shared_->bytes());
    shared_->size = bytes.size();
}

std::span<const uint8_t> Handover::content() const { return {shared_->bytes(), shared_->size}; }

}  // namespace offmap::app
