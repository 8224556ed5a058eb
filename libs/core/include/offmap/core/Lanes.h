// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace offmap::core {

/// Numbers that are compared together: one register of AVX, two of SSE. So many whatever the
/// machine, so that all come to the same.
inline constexpr uint32_t laneCount = 8;
using Lanes [[gnu::vector_size(laneCount * sizeof(float))]] = float;
using LaneNumbers [[gnu::vector_size(laneCount * sizeof(int32_t))]] = int32_t;

[[gnu::always_inline]] inline void load(const float* values, Lanes& lanes) {
    std::memcpy(&lanes, values, sizeof lanes);
}

/// Each half from a place of its own.
[[gnu::always_inline]] inline void loadHalves(const float* first, const float* second,
                                              Lanes& lanes) {
    using Half [[gnu::vector_size(sizeof(Lanes) / 2)]] = float;
    Half one, other;
    std::memcpy(&one, first, sizeof one);
    std::memcpy(&other, second, sizeof other);
    lanes = __builtin_shufflevector(one, other, 0, 1, 2, 3, 4, 5, 6, 7);
}
[[gnu::always_inline]] inline void store(const Lanes& lanes, float* values) {
    std::memcpy(values, &lanes, sizeof lanes);
}
[[gnu::always_inline]] inline void squareRoots(const Lanes& squares, Lanes& roots) {
    float values[laneCount];
    store(squares, values);
    for (float& value : values) value = std::sqrt(value);  // becomes one instruction
    load(values, roots);
}

/// The same for a single number, so that code for both can be written once.
[[gnu::always_inline]] inline void load(const float* values, float& number) { number = *values; }
[[gnu::always_inline]] inline void store(float number, float* value) { *value = number; }
[[gnu::always_inline]] inline void squareRoots(float square, float& root) {
    root = std::sqrt(square);
}

/// Without their signs.
[[gnu::always_inline]] inline void magnitudes(const Lanes& lanes, Lanes& out) {
    constexpr LaneNumbers allButSign = LaneNumbers{} + 0x7fffffff;
    out = reinterpret_cast<Lanes>(reinterpret_cast<LaneNumbers>(lanes) & allButSign);
}
[[gnu::always_inline]] inline void magnitudes(float number, float& out) { out = std::abs(number); }

/// Whether a comparison holds in any lane.
template <class Comparison>
[[gnu::always_inline]] inline bool any(const Comparison& comparison) {
    if constexpr (std::is_integral_v<Comparison>) {
        return comparison != 0;
    } else {
        uint64_t words[sizeof comparison / sizeof(uint64_t)];
        std::memcpy(words, &comparison, sizeof words);
        uint64_t all = 0;
        for (const uint64_t word : words) all |= word;
        return all != 0;
    }
}

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

/// Numbers that are summed up together: of twice the length, half as many as there are lanes.
inline constexpr uint32_t doubleLaneCount = 4;
using DoubleLanes [[gnu::vector_size(doubleLaneCount * sizeof(double))]] = double;

[[gnu::always_inline]] inline void load(const float* values, DoubleLanes& lanes) {
    lanes = DoubleLanes{values[0], values[1], values[2], values[3]};  // becomes one conversion
}
[[gnu::always_inline]] inline void load(const float* values, double& number) { number = *values; }
[[gnu::always_inline]] inline void load(const double* values, DoubleLanes& lanes) {
    std::memcpy(&lanes, values, sizeof lanes);
}
[[gnu::always_inline]] inline void store(const DoubleLanes& lanes, double* values) {
    std::memcpy(values, &lanes, sizeof lanes);
}

/// Leaves the last of the lanes as they are, the others become 0.
[[gnu::always_inline]] inline void keepLast(uint32_t count, DoubleLanes& lanes) {
    using Numbers [[gnu::vector_size(sizeof(DoubleLanes))]] = int64_t;
    constexpr Numbers fromLast = {4, 3, 2, 1};
    lanes = fromLast <= int64_t{count} ? lanes : DoubleLanes{};
}

[[gnu::always_inline]] inline double total(const DoubleLanes& lanes) {
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

}  // namespace offmap::core
