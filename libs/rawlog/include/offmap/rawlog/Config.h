// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionConfig.h>
#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/bits_math.h>

namespace offmap::rawlog {

/// How far the robot's pose is trusted.
struct PoseConfig {
    double maxAge = 0.5;                   ///< [s] from a column to the nearest pose
    double sigmaPosition = 0.05;           ///< [m] of a fixed pose, in x and in y
    double sigmaYaw = mrpt::DEG2RAD(1.0);  ///< [rad] of a fixed pose
};

/// What a map file leaves open.
struct MapConfig {
    double sigma = 0.03;  ///< [m] standard deviation of a wall that states none
};

/// Everything a user can adjust. ParameterTable.h lists it under the names that files and the
/// command line use.
struct Config {
    core::ReductionConfig reduction;
    SensorConfig sensor;
    PoseConfig pose;
    MapConfig map;

    /// \throw std::invalid_argument naming the key and its limits.
    void validate() const;
};

}  // namespace offmap::rawlog
