// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PlanePoints.h>

#include <Eigen/Core>

#include <span>

namespace offmap::core {

/// Numbers that are worked on together. So many whatever the machine, so that sums come out alike
/// on all.
inline constexpr Eigen::Index laneCount = 4;
using Lanes = Eigen::Array<double, laneCount, 1>;

inline auto lanesAt(const double* values) { return Eigen::Map<const Lanes>(values); }

/// Numbers as an array. For extremes only: a sum would depend on where they begin in memory.
inline auto arrayOf(std::span<const double> values) {
    return Eigen::Map<const Eigen::ArrayXd>(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
}

inline double sumOf(std::span<const double> values) {
    Lanes sums = Lanes::Zero();
    size_t i = 0;
    for (; i + laneCount <= values.size(); i += laneCount) sums += lanesAt(values.data() + i);
    double sum = sums.sum();
    for (; i < values.size(); ++i) sum += values[i];
    return sum;
}

}  // namespace offmap::core
