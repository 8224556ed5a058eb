// SPDX-License-Identifier: BSD-3-Clause
#include "EncodedScan.h"
#include "RotatingRows.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservationRotatingScan.h>

#include <cmath>
#include <limits>

namespace offmap::app {

namespace {

using Scan = mrpt::obs::CObservationRotatingScan;

Scan::Ptr emptyScan(const evaluation::SimulatedScan& scan, const LogSensor& sensor) {
    const auto& azimuths = sensor.scanner.azimuths;
    const auto columns = static_cast<double>(azimuths.size());
    auto obs = Scan::Create();
    obs->sensorLabel = sensor.label;
    obs->sensorPose = sensor.mounting;
    obs->timestamp = scan.scan.columns.front().time;
    obs->lidarModel = rotatingModel(sensor.scanner);
    obs->rowCount = static_cast<uint16_t>(sensor.scanner.elevations.size());
    obs->columnCount = static_cast<uint16_t>(azimuths.size());
    obs->rangeImage.setZero(obs->rowCount, obs->columnCount);
    obs->intensityImage.setZero(obs->rowCount, obs->columnCount);
    obs->rangeResolution = 0.002;
    obs->startAzimuth = azimuths.front();
    obs->azimuthSpan = azimuths.back() - azimuths.front();
    obs->sweepDuration = sensor.scanner.turnDuration * (columns - 1) / columns;
    return obs;
}

}  // namespace

std::vector<EncodedObservation> encodeRotating(const evaluation::SimulatedScan& scan,
                                               const LogSensor& sensor) {
    const auto obs = emptyScan(scan, sensor);
    const PointsByBeam points(scan, sensor.scanner);
    const std::vector<size_t> rings = ringsOfRows(sensor.scanner);
    std::vector<EncodedReturn> returns;
    for (int row = 0; row < obs->rowCount; ++row) {
        for (int column = 0; column < obs->columnCount; ++column) {
            const auto point =
                points.at(static_cast<size_t>(column), rings[static_cast<size_t>(row)]);
            if (!point) continue;
            const auto value = std::lround(rangeOf(scan, *point) / obs->rangeResolution);
            if (value < 1 || value > std::numeric_limits<uint16_t>::max()) continue;
            obs->rangeImage(row, column) = static_cast<uint16_t>(value);
            obs->intensityImage(row, column) = eightBits(intensityOf(scan, *point));
            returns.push_back({static_cast<uint32_t>(row * obs->columnCount + column), *point});
        }
    }
    return {{obs, std::move(returns)}};
}

}  // namespace offmap::app
