// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/PositionEllipse.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/SensorPose.h>

#include <mrpt/math/TPoint2D.h>

#include <optional>

namespace offmap::core {

/// What the matching has to know of the sensor while a column was taken, worked out once a column.
struct Viewpoint {
    mrpt::math::TPoint2D position;  ///< [m] map frame
    double height;                  ///< [m] z in the map frame
    PositionEllipse ellipse;        ///< of `position`, one sigma
    double sigmaHeading;            ///< [rad]
};

Viewpoint viewpointOf(const SensorPose& sensor);

/// Why nothing can be matched with a pose, if so: it is not finite, or too uncertain.
std::optional<PoseFault> faultOf(const Viewpoint& viewpoint, const MatchingConfig& config);

/// Matches one segment to the map by a ray through its centre (eqs. 1, 6, 7, corrected).
/// \param match has the segment's ground interval, and gets the rest
void matchByRay(const VerticalSegment& segment, const Viewpoint& viewpoint, const LineMap& map,
                const MatchingConfig& config, SegmentMatch& match);

}  // namespace offmap::core
