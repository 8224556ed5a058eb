// SPDX-License-Identifier: BSD-3-Clause
#include "EncodedScan.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>
#include <limits>

namespace offmap::app {

namespace {

using Scan = mrpt::obs::CObservation3DRangeScan;

Scan::Ptr emptyImage(const evaluation::SimulatedScan& scan, const LogSensor& sensor) {
    const auto columns = static_cast<int>(sensor.scanner.azimuths.size());
    const auto rows = static_cast<int>(sensor.scanner.elevations.size());
    auto obs = Scan::Create();
    obs->sensorLabel = sensor.label;
    obs->sensorPose = sensor.mounting;
    obs->timestamp = scan.scan.columns.front().time;
    obs->maxRange = static_cast<float>(sensor.scanner.maxRange);
    obs->hasRangeImage = true;
    obs->range_is_depth = true;
    obs->rangeUnits = 0.001F;
    obs->rangeImage.setSize(rows, columns);
    obs->rangeImage.fill(0);
    obs->cameraParams.ncols = static_cast<uint32_t>(columns);
    obs->cameraParams.nrows = static_cast<uint32_t>(rows);
    // the leftmost pixel looks (columns - 1) / 2 pixels to the left
    const double focalLength = 0.5 * (columns - 1) / std::tan(sensor.scanner.azimuths.front());
    obs->cameraParams.setIntrinsicParamsFromValues(focalLength, focalLength, 0.5 * (columns - 1),
                                                   0.5 * (rows - 1));
    return obs;
}

}  // namespace

std::vector<EncodedObservation> encodeRangeImage(const evaluation::SimulatedScan& scan,
                                                 const LogSensor& sensor) {
    const auto obs = emptyImage(scan, sensor);
    const PointsByBeam points(scan, sensor.scanner);
    const int rows = obs->rangeImage.rows(), columns = obs->rangeImage.cols();
    std::vector<EncodedReturn> returns;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto point =
                points.at(static_cast<size_t>(column), static_cast<size_t>(rows - 1 - row));
            if (!point) continue;
            const double depth = static_cast<double>(scan.scan.points[*point].x);
            const auto steps = std::lround(depth / static_cast<double>(obs->rangeUnits));
            if (steps < 1 || steps > std::numeric_limits<uint16_t>::max()) continue;
            obs->rangeImage(row, column) = static_cast<uint16_t>(steps);
            returns.push_back({static_cast<uint32_t>(row * columns + column), *point});
        }
    }
    return {{obs, std::move(returns)}};
}

}  // namespace offmap::app
