// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/SensorPose.h>

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/math/TPose3D.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace offmap::core {

/// One column: the returns of one firing (or of one azimuth), bottom to top, and where the sensor
/// stood.
struct ScanColumn {
    uint32_t begin = 0, end = 0;          ///< half-open range into OrganizedScan::points
    float azimuth = 0;                    ///< [rad] CCW from the vehicle's x axis, (-pi, pi]
    mrpt::Clock::time_point time{};       ///< when the column was taken
    mrpt::math::TPose3D sensorInVehicle;  ///< mounting; levels the column where it has no pose
    std::optional<SensorPose> sensor;     ///< none: the points of this column are kept
    PoseFault fault = PoseFault::NoPose;  ///< why there is none; meaningless otherwise
};

/// One turn of a 3D scanner. Columns stand in the order of rotation, either way round; they may
/// cover less than a full turn. Holds valid returns only: finite, not at the sensor's origin, no
/// exact duplicate within a column.
struct OrganizedScan {
    std::vector<mrpt::math::TPoint3Df>
        points;                         ///< [m] in the sensor's frame at the time of its column
    std::vector<uint32_t> sourceIndex;  ///< per point: its slot in the observations it came from
    std::vector<float> rangeSigma;      ///< [m] per point: standard deviation of its range; empty:
                                        ///< AlignmentConfig::sigmaRange of every one
    std::vector<ScanColumn> columns;    ///< their ranges follow each other and cover `points`

    std::span<const mrpt::math::TPoint3Df> column(size_t c) const {
        return {points.data() + columns[c].begin, points.data() + columns[c].end};
    }

    /// [m] Of a point's range. \param usual where the scan does not tell
    double rangeSigmaOf(uint32_t point, double usual) const {
        return rangeSigma.empty() ? usual : static_cast<double>(rangeSigma[point]);
    }
};

}  // namespace offmap::core
