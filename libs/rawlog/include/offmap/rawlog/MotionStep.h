// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/SensorPose.h>
#include <offmap/rawlog/GroundCovariance.h>

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose3D.h>
#include <mrpt/obs/CActionCollection.h>

#include <optional>

namespace offmap::rawlog {

/// How the vehicle moved since the step before, compact: hours of them are held in memory.
struct MotionStep {
    /// When it had moved so; none: not told, as where no sensory frame follows an action.
    std::optional<mrpt::Clock::time_point> time;
    mrpt::math::TPose3D vehicleInPrevious;  ///< [m], [rad]
    GroundTriangle groundCovariance{};      ///< in the frame of the step before
    std::optional<core::PoseFault> fault;   ///< NotFinite or NotPsd: nobody knows how it moved
};

/// The first movement among the actions, its time not told; none if they hold no movement.
std::optional<MotionStep> movementOf(const mrpt::obs::CActionCollection& actions);

}  // namespace offmap::rawlog
