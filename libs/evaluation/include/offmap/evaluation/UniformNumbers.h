// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace offmap::evaluation {

/// Evenly distributed numbers that a seed determines with every standard library, as those of
/// std::uniform_real_distribution are not.
class UniformNumbers {
 public:
    explicit UniformNumbers(uint64_t seed) : generator_(seed) {}

    /// The next number in [low, high).
    double between(double low, double high);
    /// True with this probability.
    bool chance(double probability) { return between(0, 1) < probability; }
    /// One of 0 .. count - 1. \throw std::invalid_argument if count is 0
    size_t below(size_t count);

 private:
    std::mt19937_64 generator_;
};

}  // namespace offmap::evaluation
