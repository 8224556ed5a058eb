// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint3D.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace offmap::profit {

/// Indices into the points, ascending.
using Cluster = std::vector<uint32_t>;

/// Euclidean clustering, as object detectors begin with it: points nearer to each other than
/// `tolerance` [m] are of one cluster. \return those of at least `minPoints`
std::vector<Cluster> clustersOf(std::span<const mrpt::math::TPoint3Df> points, float tolerance,
                                size_t minPoints);

}  // namespace offmap::profit
