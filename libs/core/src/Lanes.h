// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

namespace offmap::core {

/// Numbers that are compared together: one register of AVX, two of SSE. So many whatever the
/// machine, so that all come to the same.
inline constexpr uint32_t laneCount = 8;
using Lanes [[gnu::vector_size(laneCount * sizeof(float))]] = float;
using LaneNumbers [[gnu::vector_size(laneCount * sizeof(int32_t))]] = int32_t;

[[gnu::always_inline]] inline void load(const float* values, Lanes& lanes) {
    std::memcpy(&lanes, values, sizeof lanes);
}

/// The same for a single number, so that code for both can be written once.
[[gnu::always_inline]] inline void load(const float* values, float& number) { number = *values; }

/// The greatest of all lanes ends up in each.
template <class Numbers>
[[gnu::always_inline]] inline void spreadGreatest(Numbers& v) {
    const Numbers halves = __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
    v = halves > v ? halves : v;
    const Numbers quarters = __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5);
    v = quarters > v ? quarters : v;
    const Numbers eighths = __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6);
    v = eighths > v ? eighths : v;
}

/// Sums of many numbers, four at a time.
inline constexpr uint32_t sumCount = 4;
using Sums [[gnu::vector_size(sumCount * sizeof(double))]] = double;

[[gnu::always_inline]] inline void load(const float* values, Sums& sums) {
    sums = Sums{values[0], values[1], values[2], values[3]};  // becomes one conversion
}

/// Leaves the last of the lanes as they are, the others become 0.
[[gnu::always_inline]] inline void keepLast(uint32_t lanes, Sums& sums) {
    using Numbers [[gnu::vector_size(sizeof(Sums))]] = int64_t;
    constexpr Numbers fromLast = {4, 3, 2, 1};
    sums = fromLast <= int64_t{lanes} ? sums : Sums{};
}

[[gnu::always_inline]] inline double total(const Sums& sums) {
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace offmap::core
