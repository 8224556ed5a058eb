// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/SensorPose.h>

#include <Eigen/Core>
#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <optional>

namespace offmap::rawlog {

/// The vehicle's pose at one time, or why there is none.
struct PoseLookup {
    std::optional<mrpt::poses::CPose3D> vehicleInMap;
    Eigen::Matrix3d groundCovariance = Eigen::Matrix3d::Zero();  ///< of x, y [m] and yaw [rad]
    core::PoseFault fault = core::PoseFault::NoPose;             ///< meaningless if there is a pose
};

/// Says where the vehicle was. Implementations: FixedPose, PoseTrack.
class PoseSource {
 public:
    virtual ~PoseSource() = default;
    virtual PoseLookup at(mrpt::Clock::time_point time) const = 0;
};

}  // namespace offmap::rawlog
