// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/PoseCorrection.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/WallGeometry.h>
#include <offmap/core/WallSight.h>

#include <mrpt/math/TPoint2D.h>

namespace offmap::core {

/// [m^2] Variance across a wall of a sight's middle, by the noise of its ranges.
double varianceOfSight(const WallSight& sight, const mrpt::math::TPoint2D& normal,
                       const AlignmentConfig& config);

/// How a place that a column sees stands to a wall.
struct WallOffset {
    double behind;  ///< [m] distanceBehind()
    double sigma;   ///< [m] of `behind`: pose, map and sensor
    double across;  ///< [-] sine of the beam's incidence angle
};

/// \param index of the wall \param noise [m^2] variance of the place along the beam
WallOffset offsetFrom(const LineMap& map, uint32_t index, const PoseCorrection& correction,
                      const CorrectedColumn& column, const SeenPoint& point,
                      const mrpt::math::TPoint2D& beam, double noise);

/// Whether a place that a column sees is within so many sigmas of a wall. What offsetFrom() tells
/// of it, without its roots. \param noise [m^2] variance of the place along the beam
bool isWithinGate(const LineMap& map, uint32_t index, const PoseCorrection& correction,
                  const CorrectedColumn& column, const SeenPoint& point, double noise, double gate);

/// Matches a segment to the wall nearest to where the corrected pose puts it; it is mapped if it
/// stands within the gate. \param turn of the correction
SegmentMatch matchByGate(const WallSight& sight, const Interval& measured,
                         const PoseCorrection& correction, const Turn& turn, const LineMap& map,
                         const ReductionConfig& config);

}  // namespace offmap::core
