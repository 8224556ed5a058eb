// SPDX-License-Identifier: BSD-3-Clause
#include "EncodedScan.h"

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <numbers>

namespace offmap::app {

namespace {

using Fan = mrpt::obs::CObservation2DRangeScan;

/// A scanner on its side that looks along an azimuth: its rays run from bottom to top.
Fan::Ptr emptyFan(const core::ScanColumn& column, double azimuth, const LogSensor& sensor) {
    const auto& elevations = sensor.scanner.elevations;
    auto fan = Fan::Create();
    fan->sensorLabel = sensor.label;
    fan->timestamp = column.time;
    fan->sensorPose =
        sensor.mounting + mrpt::poses::CPose3D(0, 0, 0, azimuth, 0, std::numbers::pi / 2);
    fan->maxRange = static_cast<float>(sensor.scanner.maxRange);
    fan->rightToLeft = true;
    fan->aperture = static_cast<float>(elevations.back() - elevations.front());
    fan->resizeScanAndAssign(elevations.size(), 0.0F, false);
    fan->setScanHasIntensity(true);
    return fan;
}

}  // namespace

std::vector<EncodedObservation> encodeSweep(const evaluation::SimulatedScan& scan,
                                            const LogSensor& sensor) {
    const PointsByBeam points(scan, sensor.scanner);
    std::vector<EncodedObservation> fans;
    for (size_t c = 0; c < scan.scan.columns.size(); ++c) {
        const auto fan = emptyFan(scan.scan.columns[c], sensor.scanner.azimuths[c], sensor);
        std::vector<EncodedReturn> returns;
        for (size_t ring = 0; ring < sensor.scanner.elevations.size(); ++ring) {
            const auto point = points.at(c, ring);
            if (!point) {
                fan->setScanIntensity(ring, 0);
                continue;
            }
            fan->setScanRange(ring, static_cast<float>(rangeOf(scan, *point)));
            fan->setScanRangeValidity(ring, true);
            fan->setScanIntensity(ring, eightBits(intensityOf(scan, *point)));
            returns.push_back({static_cast<uint32_t>(ring), *point});
        }
        fans.push_back({fan, std::move(returns)});
    }
    return fans;
}

}  // namespace offmap::app
