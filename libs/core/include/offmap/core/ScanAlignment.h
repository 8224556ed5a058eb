// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Alignment.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/PoseCorrection.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/WallInformation.h>
#include <offmap/core/WallSight.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::core {

/// Working memory: what the sights tell of each wall that they may be of.
struct AlignmentScratch {
    std::vector<uint32_t> walls;  ///< indices into LineMap::walls()
    std::vector<WallInformation> informations;
};

/// The correction that the stated covariance alone allows: none, with its uncertainty.
/// \param stated covariance of x, y [m] and heading [rad] at the pivot
PoseCorrection uncorrected(const mrpt::math::TPoint2D& pivot, const Eigen::Matrix3d& stated,
                           const AlignmentConfig& config);

/// The maximum a posteriori correction of a scan's poses: the sights against the walls they may
/// belong to are the measurements, the stated covariance is the prior. Robust Gauss-Newton, which
/// looks for walls within what the prior leaves open first, and ever closer by. Where far fewer
/// sights fit than with a wider prior, the wider one is believed: localisation tends to be too sure
/// of itself.
Alignment align(std::span<const WallSight> sights, const LineMap& map,
                const mrpt::math::TPoint2D& pivot, const Eigen::Matrix3d& stated,
                const AlignmentConfig& config, AlignmentScratch& scratch);

}  // namespace offmap::core
