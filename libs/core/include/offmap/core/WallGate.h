// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/PoseCorrection.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/WallSight.h>

#include <mrpt/math/TPoint2D.h>

namespace offmap::core {

/// Unit normal of a wall that points the way the beam goes. \param beam map axes
mrpt::math::TPoint2D normalAwayFrom(const mrpt::math::TPoint2D& beam, const Wall& wall);

/// [m] From the wall's line, along that normal: negative in front of it.
double distanceBehind(const mrpt::math::TPoint2D& place, const Wall& wall,
                      const mrpt::math::TPoint2D& normal);

/// [m^2] Variance across a wall of a sight's middle, by the noise of its ranges.
double varianceOfSight(const WallSight& sight, const mrpt::math::TPoint2D& normal,
                       const AlignmentConfig& config);

/// How a place that a column sees stands to a wall.
struct WallOffset {
    double behind;    ///< [m] distanceBehind()
    double distance;  ///< [m] from the wall, which has ends
    double sigma;     ///< [m] of `behind`: pose, map and sensor
};

/// \param noise [m^2] variance of the place along the beam
WallOffset offsetFrom(const Wall& wall, const PoseCorrection& correction, const ColumnPlace& column,
                      const SeenPoint& point, const mrpt::math::TPoint2D& beam, double noise);

/// Matches a segment to the wall nearest to where the corrected pose puts it; it is mapped if it
/// stands within the gate.
SegmentMatch matchByGate(const WallSight& sight, const Interval& measured,
                         const PoseCorrection& correction, const LineMap& map,
                         const ReductionConfig& config);

}  // namespace offmap::core
