// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace offmap::rawlog {

/// What the columns of a turned 2D scanner's own poses mean.
enum class PoseReference : uint8_t {
    Auto,    ///< Turn if x, y of sensorPose vary within a turn, else Column
    Turn,    ///< the movement is already in sensorPose; one vehicle pose, of the first column, for
             ///< all
    Column,  ///< every column is placed by the vehicle pose at its own time
};

/// How observations become columns.
struct SensorConfig {
    PoseReference poseReference = PoseReference::Auto;
    uint32_t columnsPerTurn =
        0;  ///< a turn ends after so many columns; 0: only at the azimuth's wrap
    double maxColumnPause = 1.0;  ///< [s] a longer pause between two columns ends the turn
    double columnWidth =
        0.0;  ///< [rad] azimuth width of a point cloud's column; 0: found in the cloud

    /// \throw std::invalid_argument naming the field and its limits.
    void validate() const;
};

}  // namespace offmap::rawlog
