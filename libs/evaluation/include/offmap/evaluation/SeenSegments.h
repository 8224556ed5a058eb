// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Interval.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>

#include <Eigen/Core>
#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <vector>

namespace offmap::evaluation {

/// A vertical segment as a place in the map where a surface was seen.
struct SeenSegment {
    uint32_t column;              ///< of the scan
    mrpt::math::TPoint2D sensor;  ///< [m] map frame
    mrpt::math::TPoint2D place;   ///< [m] map frame, mean of its returns
    Eigen::Matrix2d covariance;   ///< [m^2] of the place, by what the pose is uncertain
    core::Interval height;        ///< [m] z in the map frame that it reaches from and to
    uint32_t returns;
    bool seenOver;  ///< returns of its column lie above and beyond it, as those of a wall do behind
                    ///< a thing that does not reach to the ceiling
};

/// The segments of a reduced scan whose columns have a pose that can be used, in the order of the
/// segments. The poses are the corrected ones if the scan was aligned and fits, else the stated.
std::vector<SeenSegment> seenSegments(const core::OrganizedScan& scan,
                                      const core::ReductionResult& result,
                                      const core::ReductionConfig& config);

}  // namespace offmap::evaluation
