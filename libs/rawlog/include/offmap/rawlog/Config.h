// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionConfig.h>
#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/TPose3D.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// How far the robot's pose is trusted.
struct PoseConfig {
    double maxAge = 0.5;                   ///< [s] from a column to the nearest pose
    double sigmaPosition = 0.05;           ///< [m] of a pose that states none, in x and in y
    double sigmaYaw = mrpt::DEG2RAD(1.0);  ///< [rad] of a pose that states none
};

/// How far odometry is trusted: standard deviations that grow with the root of the way.
struct OdometryConfig {
    double positionPerMetre = 0.05;                ///< [m] of x and of y after 1 m
    double headingPerMetre = mrpt::DEG2RAD(0.5);   ///< [rad] after 1 m
    double headingPerRadian = mrpt::DEG2RAD(3.0);  ///< [rad] after 1 rad
};

/// What holds for the layers of a map that a name fits.
struct LayerConfig {
    std::string layer;                     ///< with * and ? as wildcards
    std::optional<double> sigma{};         ///< [m] standard deviation of its walls' position
    std::optional<double> zMin{}, zMax{};  ///< [m] map frame; without: down, up to everywhere
    bool present = true;                   ///< false: its lines are no walls
};

/// What a map file leaves open.
struct MapConfig {
    double sigma = 0.03;              ///< [m] standard deviation of a wall that states none
    double minLength = 0.05;          ///< [m] shorter lines of drawings are no walls
    std::vector<LayerConfig> layers;  ///< the first that fits a layer counts
};

/// Everything a user can adjust. ParameterTable.h lists it under the names that files and the
/// command line use.
struct Config {
    core::ReductionConfig reduction;
    SensorConfig sensor;  ///< of sensors that are set nothing of their own
    /// Settings of single sensors: by label, the name of the parameter in its section and its text.
    std::map<std::string, std::map<std::string, std::string>> sensors;
    std::map<std::string, mrpt::math::TPose3D> mountings;  ///< by label, instead of the log's
    PoseConfig pose;
    OdometryConfig odometry;
    MapConfig map;

    /// \throw std::invalid_argument naming the key and its limits.
    void validate() const;

    /// What holds for one sensor. \throw std::invalid_argument naming a key that is wrong
    SensorConfig sensorOf(const std::string& label) const;
};

}  // namespace offmap::rawlog
