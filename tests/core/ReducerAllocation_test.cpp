// SPDX-License-Identifier: BSD-3-Clause
// Counts what is taken from the heap, by operators of its own.
#include "SmallRoom.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

namespace {

thread_local size_t allocations = 0;

void* allocate(size_t size) {
    ++allocations;
    void* memory = std::malloc(size > 0 ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void* allocateAligned(size_t size, std::align_val_t alignment) {
    ++allocations;
    const auto to = static_cast<size_t>(alignment);
    void* memory = std::aligned_alloc(to, (size + to - 1) / to * to);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(size_t size) { return allocate(size); }
void* operator new[](size_t size) { return allocate(size); }
void* operator new(size_t size, std::align_val_t alignment) {
    return allocateAligned(size, alignment);
}
void* operator new[](size_t size, std::align_val_t alignment) {
    return allocateAligned(size, alignment);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t, std::align_val_t) noexcept { std::free(memory); }

namespace offmap::core {

namespace {

/// What one more look at a scan takes, once a reducer has seen it.
size_t allocationsOnceWarm(const OrganizedScan& scan, const ReductionConfig& config) {
    const test::SmallRoom room;
    Reducer reducer(room.map, config);
    reducer.reduce(scan);
    const size_t before = allocations;
    reducer.reduce(scan);
    return allocations - before;
}

}  // namespace

TEST(ReducerAllocation, isCountedHere) {
    const size_t before = allocations;
    const test::SmallRoom room;
    EXPECT_GT(allocations, before);
}

TEST(ReducerAllocation, isNoneOnceWarm) {
    const test::SmallRoom room;
    OrganizedScan scan = room.built.scan;
    for (const bool noisy : {false, true}) {
        if (noisy) scan.rangeSigma.assign(scan.points.size(), 0.02F);
        for (const MatchingMethod method :
             {MatchingMethod::Paper, MatchingMethod::Probabilistic, MatchingMethod::Aligned}) {
            ReductionConfig config;
            config.matching.method = method;
            config.orphan.remove = true;
            EXPECT_EQ(allocationsOnceWarm(scan, config), 0U)
                << "method " << int(method) << (noisy ? ", a sigma for each return" : "");
        }
    }
}

}  // namespace offmap::core
