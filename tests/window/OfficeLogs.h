// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/LogFiles.h"
#include "../support/TemporaryFolder.h"
#include "Session.h"

#include <offmap/core/LineMap.h>
#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnReducer.h>

#include <mrpt/obs/CObservationPointCloud.h>

#include <filesystem>
#include <string>
#include <vector>

namespace offmap::test {

/// A robot that drives through its office: a small cloud and a pose every tenth of a second.
inline Observations officeDrive(size_t turns) {
    SimulatedRobot robot;
    Observations log;
    for (size_t i = 0; i < turns; ++i) {
        log.insert(log.end(), {robot.localisation(), robot.cloud()});
        robot.wait(0.1);
        robot.pose.x_incr(0.02);
    }
    log.push_back(robot.localisation());
    return log;
}

inline std::shared_ptr<const core::LineMap> officeLines() {
    return std::make_shared<core::LineMap>(mapOf(evaluation::officeRoom()));
}

/// A scan of the robot's office from that place, reduced.
inline live::LiveFramePtr officeFrame(uint64_t number, double x = 2, double y = 2.5) {
    SimulatedRobot robot;
    robot.pose.x(x);
    robot.pose.y(y);
    const auto map = officeLines();
    const rawlog::FixedPose poses({x, y, robot.pose.yaw()}, 0.02, 0.01);
    const rawlog::Config config;
    rawlog::TurnReducer reducer(*map, poses, config, rawlog::OutputClass::Same);
    auto frame = std::make_shared<live::LiveFrame>();
    frame->arrived.turn = {robot.cloud()};
    frame->arrived.number = number;
    const auto* scanClass = rawlog::scanClassOf(*frame->arrived.turn[0], {});
    frame->reduced = reducer.reduce(frame->arrived.turn, *scanClass);
    frame->result = reducer.result();
    return frame;
}

/// When the scans of a log were taken.
inline std::vector<mrpt::Clock::time_point> scanTimes(const Observations& log) {
    std::vector<mrpt::Clock::time_point> times;
    for (const auto& obs : log) {
        if (dynamic_cast<const mrpt::obs::CObservationPointCloud*>(obs.get()))
            times.push_back(obs->timestamp);
    }
    return times;
}

inline size_t pointsIn(const Observations& log) {
    size_t points = 0;
    for (const auto& obs : log) {
        const auto* cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud*>(obs.get());
        if (cloud) points += cloud->pointcloud->size();
    }
    return points;
}

/// What the window asks for. \param map may be empty, as the log may
inline window::SessionRequest requestOf(const std::filesystem::path& log,
                                        const std::filesystem::path& map) {
    window::SessionRequest request;
    request.live.from.source = log.string();
    request.live.from.speed = "max";
    request.live.shared.map = map;
    request.live.forWindow = true;
    return request;
}

}  // namespace offmap::test
