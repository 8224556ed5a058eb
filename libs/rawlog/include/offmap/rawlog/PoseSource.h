// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/SensorPose.h>

#include <Eigen/Core>
#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <optional>

namespace offmap::rawlog {

/// The vehicle's pose at one time, or why there is none.
struct PoseLookup {
    std::optional<mrpt::poses::CPose3D> vehicleInMap;
    Eigen::Matrix3d groundCovariance = Eigen::Matrix3d::Zero();  ///< of x, y [m] and yaw [rad]
    core::PoseFault fault = core::PoseFault::NoPose;             ///< meaningless if there is a pose
};

/// Up to when the poses of a source will not change any more.
struct SettledPoses {
    /// The answers for all times before stay what they are ...
    mrpt::Clock::time_point until = mrpt::Clock::time_point::min();
    /// ... as long as this does.
    uint64_t revision = 0;
};

/// Of a source to which nothing comes.
inline constexpr SettledPoses allSettled{mrpt::Clock::time_point::max(), 0};

/// Says where the vehicle was. Implementations: FixedPose, PoseTrack.
class PoseSource {
 public:
    virtual ~PoseSource() = default;
    virtual PoseLookup at(mrpt::Clock::time_point time) const = 0;

    /// Columns whose poses are settled need not wait for the end of their turn. By default none is.
    virtual SettledPoses settled() const { return {}; }
};

}  // namespace offmap::rawlog
