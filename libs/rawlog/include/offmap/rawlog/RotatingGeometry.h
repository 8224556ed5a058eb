// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Direction.h>
#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservationRotatingScan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// Where the cells of a CObservationRotatingScan look, and when.
///
/// Column c looks at startAzimuth + azimuthSpan c / (columns - 1), as MRPT documents it. What MRPT
/// makes of Velodyne packets is different: columnCount is the number of returns, rowCount times too
/// large (twice that, if there are two returns of a beam), and the columns behind those in use are
/// empty. There azimuthSpan ends where the column behind the last would begin, and columns 2k and
/// 2k + 1 of a VLP-16 have the azimuth of the block that both were taken from.
class RotatingGeometry {
 public:
    /// \pre the scan is supported with this configuration (unsupportedRotatingScan)
    RotatingGeometry(const mrpt::obs::CObservationRotatingScan& obs, const SensorConfig& config);

    /// Columns in which a return can stand; the ones behind them are empty.
    uint32_t columns() const { return columns_; }
    /// Neighbouring columns that are of one firing: 1 or 2. Divides columns().
    uint32_t columnsPerFiring() const { return columnsPerFiring_; }

    /// [rad] CCW from the sensor's x axis
    double azimuth(uint32_t column) const;
    mrpt::Clock::time_point time(uint32_t column) const;
    /// [m] in the sensor's frame. \param value of the range image
    mrpt::math::TPoint3Df point(uint32_t row, uint32_t column, uint16_t value) const;

 private:
    /// Columns from the first to that with which the column's firing begins.
    double steps(uint32_t column) const { return column - column % columnsPerFiring_; }

    std::vector<Direction> elevations_;  // by row
    std::vector<Direction> azimuths_;    // by column
    double rangeResolution_;             // [m]
    uint32_t columns_, columnsPerFiring_;
    double startAzimuth_, azimuthStep_;  // [rad] CCW
    mrpt::Clock::time_point startTime_;
    double timeStep_;  // [s]
};

/// Why the returns of such a scan cannot be placed; none if they can.
std::optional<std::string> unsupportedRotatingScan(const mrpt::obs::CObservationRotatingScan& obs,
                                                   const SensorConfig& config);

}  // namespace offmap::rawlog
