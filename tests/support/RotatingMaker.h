// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservationRotatingScan.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace offmap::test {

using RotatingScanObservation = mrpt::obs::CObservationRotatingScan;

/// A full turn without returns, counter-clockwise from the x axis, in units of 2 mm and 0.1 s, of a
/// model that nobody knows.
inline auto emptyRotatingScan(uint16_t rows, uint16_t columns) {
    auto scan = std::make_shared<RotatingScanObservation>();
    scan->lidarModel = "SIMULATED";
    scan->timestamp = mrpt::Clock::fromDouble(1.7e9);
    scan->rowCount = rows;
    scan->columnCount = columns;
    scan->rangeImage.setZero(rows, columns);
    scan->rangeResolution = 0.002;
    scan->startAzimuth = 0;
    scan->azimuthSpan = 2 * std::numbers::pi * (columns - 1) / columns;
    scan->sweepDuration = 0.1;
    return scan;
}

/// \param elevations [rad]
inline rawlog::SensorConfig withElevations(std::vector<double> elevations) {
    rawlog::SensorConfig config;
    config.elevations = std::move(elevations);
    return config;
}

/// [deg] of the rows of rotatingScanOf(): 32, top to bottom.
inline std::vector<double> rotatingElevations() {
    std::vector<double> elevations;
    for (int row = 0; row < 32; ++row) elevations.push_back(46.5 - 3.0 * row);
    return elevations;
}

/// The same as a value of sensor.elevations_deg.
inline std::string rotatingElevationsText() {
    std::string text;
    for (const double elevation : rotatingElevations()) {
        text += (text.empty() ? "[" : ", ") + std::to_string(elevation);
    }
    return text + "]";
}

/// \param rangeAlong from a unit vector in the sensor's frame to the range [m]; 0: no return
template <class RangeAlong>
auto rotatingScanOf(RangeAlong&& rangeAlong, uint16_t columns) {
    const auto elevations = rotatingElevations();
    const auto scan = emptyRotatingScan(static_cast<uint16_t>(elevations.size()), columns);
    scan->intensityImage.setZero(scan->rowCount, columns);
    for (int column = 0; column < columns; ++column) {
        const double azimuth = 2 * std::numbers::pi * column / columns;
        for (int row = 0; row < scan->rowCount; ++row) {
            const double up = mrpt::DEG2RAD(elevations[static_cast<size_t>(row)]);
            const double range = rangeAlong(mrpt::math::TVector3D{
                std::cos(up) * std::cos(azimuth), std::cos(up) * std::sin(azimuth), std::sin(up)});
            scan->rangeImage(row, column) =
                static_cast<uint16_t>(std::lround(range / scan->rangeResolution));
            scan->intensityImage(row, column) = static_cast<uint8_t>(range > 0 ? 10 + row : 0);
        }
    }
    return scan;
}

/// Adds last returns: every third is 0.5 m behind the strongest, the others are the same one.
inline void addLastReturns(RotatingScanObservation& scan) {
    auto& last = scan.rangeOtherLayers["LAST"];
    last = scan.rangeImage;
    for (int column = 0; column < last.cols(); column += 3) {
        for (int row = 0; row < last.rows(); ++row) {
            if (last(row, column) != 0)
                last(row, column) = static_cast<uint16_t>(last(row, column) + 250);
        }
    }
}

}  // namespace offmap::test
