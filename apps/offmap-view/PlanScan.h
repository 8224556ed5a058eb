// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/LiveFrame.h>

#include <Eigen/Core>
#include <mrpt/math/TPoint2D.h>

#include <optional>
#include <vector>

namespace offmap::window {

/// Where a sensor stood, as a plan shows it.
struct PlanPose {
    mrpt::math::TPoint2D place;                            ///< [m] map frame
    double heading = 0;                                    ///< [rad] map frame
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< [m^2] of x and y, map axes
};

/// What a plan shows of a turn.
struct PlanScan {
    std::optional<PlanPose> stated;   ///< of the sensor in the middle of the turn; none: no pose
    std::optional<PlanPose> refined;  ///< the same as the scan shows it; none: not corrected
    std::vector<mrpt::math::TPoint2D> kept;  ///< [m] map frame: returns on kept vertical segments
};

/// The poses alone, which costs nothing.
PlanScan planPosesOf(const live::LiveFrame& frame);
/// The kept returns too, where the scan was found to have been taken.
PlanScan planScanOf(const live::LiveFrame& frame);

/// The ellipse of that many standard deviations, as a closed polygon [m]; none if it has no width
/// or is not finite.
std::vector<mrpt::math::TPoint2D> ellipseOutline(const PlanPose& pose, double deviations);

}  // namespace offmap::window
