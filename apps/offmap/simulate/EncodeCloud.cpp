// SPDX-License-Identifier: BSD-3-Clause
#include "EncodedScan.h"

#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>

namespace offmap::app {

namespace {

/// From the sensor's frame during each column to that during the first.
std::vector<mrpt::poses::CPose3D> movementsOf(const core::OrganizedScan& scan) {
    std::vector<mrpt::poses::CPose3D> movements;
    for (const core::ScanColumn& column : scan.columns) {
        movements.push_back(column.sensor->sensorInMap - scan.columns.front().sensor->sensorInMap);
    }
    return movements;
}

}  // namespace

std::vector<EncodedObservation> encodeCloud(const evaluation::SimulatedScan& scan,
                                            const LogSensor& sensor) {
    auto obs = mrpt::obs::CObservationPointCloud::Create();
    obs->sensorLabel = sensor.label;
    obs->sensorPose = sensor.mounting;
    obs->timestamp = scan.scan.columns.front().time;
    auto cloud = mrpt::maps::CPointsMapXYZI::Create();
    const auto movements = movementsOf(scan.scan);
    std::vector<EncodedReturn> returns;
    for (size_t c = 0; c < scan.scan.columns.size(); ++c) {
        const bool moved = sensor.compensated && movements[c] != mrpt::poses::CPose3D();
        for (uint32_t i = scan.scan.columns[c].begin; i < scan.scan.columns[c].end; ++i) {
            mrpt::math::TPoint3Df p = scan.scan.points[i];
            if (moved) p = movements[c].composePoint(mrpt::math::TPoint3D(p)).cast<float>();
            returns.push_back({static_cast<uint32_t>(cloud->size()), i});
            cloud->insertPointRGB(p.x, p.y, p.z, intensityOf(scan, i), 0, 0);
        }
    }
    obs->pointcloud = cloud;
    return {{obs, std::move(returns)}};
}

}  // namespace offmap::app
