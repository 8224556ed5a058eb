// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/MotionStep.h>

namespace offmap::rawlog {

/// The movement between two readings of odometry, along the arc that joins them. Its noise is a
/// random walk: variances grow with the way and with the turn, so that it does not matter in how
/// many readings a way is told. Faulty if a reading is not finite.
MotionStep motionBetween(const StampedOdometry& before, const StampedOdometry& after,
                         const OdometryConfig& noise);

}  // namespace offmap::rawlog
