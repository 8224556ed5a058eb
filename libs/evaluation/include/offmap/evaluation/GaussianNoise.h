// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>

namespace offmap::evaluation {

/// Normally distributed numbers that a seed determines with every standard library, as those of
/// std::normal_distribution are not (Box-Muller transform).
class GaussianNoise {
 public:
    explicit GaussianNoise(uint64_t seed) : generator_(seed) {}

    /// The next number, of mean 0 and standard deviation sigma.
    double next(double sigma = 1);

 private:
    double uniform();  ///< in (0, 1]

    std::mt19937_64 generator_;
    std::optional<double> spare_;  ///< the transform yields two at a time
};

}  // namespace offmap::evaluation
