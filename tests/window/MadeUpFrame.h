// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/live/LiveFrame.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

namespace offmap::test {

/// A hall of 20 m by 12 m from the origin, with a round column of 1 m in its middle.
inline std::shared_ptr<const core::LineMap> hallMap() {
    std::vector<core::Wall> walls{
        {{{0, 0}, {20, 0}}}, {{{20, 0}, {20, 12}}}, {{{20, 12}, {0, 12}}}, {{{0, 12}, {0, 0}}}};
    for (const double side : {-1.0, 1.0}) {
        core::Wall half{{{10 - side, 6}, {10 + side, 6}}};
        half.curvature = 1;
        walls.push_back(half);
    }
    return std::make_shared<core::LineMap>(std::move(walls));
}

/// A scanner at (6, 4, 1) in the map that looks along the map's y axis, whose position is known to
/// 0.2 m along x and 0.1 m along y, and one pole of eleven returns that the map does not have: at
/// (9, 4). The scan shows the sensor 0.3 m further along x.
inline live::LiveFrame madeUpFrame() {
    live::LiveFrame frame;
    core::OrganizedScan& scan = frame.reduced.organized.scan;
    core::ScanColumn column;
    for (int i = 0; i <= 10; ++i) {
        scan.points.emplace_back(0.0F, -3.0F, -1.0F + 0.2F * static_cast<float>(i));
    }
    column.end = 11;
    core::SensorPose& pose = column.sensor.emplace();
    pose.sensorInMap = {6, 4, 1, M_PI / 2, 0, 0};
    pose.groundCovariance.diagonal() << 0.04, 0.01, 0.001;
    scan.columns.push_back(column);
    frame.result.labels.assign(scan.points.size(), core::PointLabel::Kept);
    core::PoseCorrection& correction = frame.result.alignment.emplace().correction;
    correction.pivot = {6, 4};
    correction.mean[0] = 0.3;
    correction.covariance.diagonal() << 1e-4, 1e-4, 1e-6, 1e-6, 1e-6;
    frame.reduced.vehicleInMap.emplace();
    frame.reduced.record.time = mrpt::Clock::fromDouble(1e9);
    return frame;
}

}  // namespace offmap::test
