// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose3D.h>

#include <optional>

namespace offmap::rawlog {

/// How far and how fast a vehicle went, from its poses as they come in order of time.
class Movement {
 public:
    /// \param sigma [m] standard deviation of the position: a vehicle that stands seems to move by
    /// so much from pose to pose
    void add(mrpt::Clock::time_point time, const mrpt::math::TPose3D& vehicleInMap, double sigma);

    double distance() const { return distance_; }        ///< [m] to within 3 sigma, at least 0.1 m
    double seconds() const { return seconds_; }          ///< [s] from the first to the last pose
    double maxSpeed() const { return maxSpeed_; }        ///< [m/s] over half a second or more
    double maxTurnRate() const { return maxTurnRate_; }  ///< [rad/s] of the heading, likewise
    /// [m/s] none while no time has passed.
    std::optional<double> meanSpeed() const;

 private:
    struct Pose {
        mrpt::Clock::time_point time;
        mrpt::math::TPose3D vehicleInMap;
    };
    std::optional<Pose> first_, latest_, corner_;  ///< of all, of the speeds, of the distance
    double distance_ = 0, seconds_ = 0, maxSpeed_ = 0, maxTurnRate_ = 0;
};

}  // namespace offmap::rawlog
