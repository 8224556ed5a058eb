// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace offmap::rawlog {

/// What the columns of a turned 2D scanner's own poses mean.
enum class PoseReference : uint8_t {
    Auto,    ///< Turn if x, y of sensorPose vary within a turn, else Column
    Turn,    ///< the movement is already in sensorPose; one vehicle pose, of the first column, for
             ///< all
    Column,  ///< every column is placed by the vehicle pose at its own time
};

/// Which moment of a scan its time stamp tells.
enum class TimeReference : uint8_t { First, Middle, Last };

/// The way round in which a CObservationRotatingScan counts its azimuth.
enum class AzimuthSense : uint8_t {
    Auto,              ///< Clockwise for what MRPT converted from Velodyne packets
    CounterClockwise,  ///< as MRPT documents startAzimuth and azimuthSpan
    Clockwise,
};

/// A box around the robot, in the vehicle's frame. \pre min < max in every axis
struct RobotBox {
    mrpt::math::TPoint3D min, max;  ///< [m]
};

/// How the observations of one sensor become columns.
struct SensorConfig {
    PoseReference poseReference = PoseReference::Auto;
    uint32_t columnsPerTurn =
        0;  ///< a turn ends after so many columns; 0: only at the azimuth's wrap
    double maxColumnPause = 1.0;  ///< [s] a longer pause between two columns ends the turn
    double columnWidth =
        0.0;  ///< [rad] azimuth width of a point cloud's column; 0: found in the cloud
    TimeReference timeReference = TimeReference::First;
    AzimuthSense azimuthSense = AzimuthSense::Auto;
    std::vector<double> elevations;  ///< [rad] of a range image's rows, row 0 first; empty: known
                                     ///< from the sensor's model
    /// Pairs of an intensity, 0 ... 1, ascending, and the standard deviation [m] of the ranges of
    /// returns that bright; linear between, constant beyond. Empty: AlignmentConfig::sigmaRange.
    std::vector<double> rangeSigmaByIntensity;
    double minRange = 0;               ///< [m] nearer returns are the robot's own, and kept
    std::optional<RobotBox> robotBox;  ///< returns in it are the robot's own, and kept
    std::optional<mrpt::poses::CPose3D> mounting;  ///< instead of what the observations say

    /// \throw std::invalid_argument naming the field and its limits.
    void validate() const;
};

/// Where the sensor of an observation is mounted: as it says, if the configuration does not.
mrpt::poses::CPose3D sensorInVehicle(const mrpt::obs::CObservation& obs,
                                     const SensorConfig& config);

}  // namespace offmap::rawlog
