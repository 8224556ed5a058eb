// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceFixture.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <nlohmann/json.hpp>

namespace offmap::test {

/// A folder with a log that `offmap info` is asked about.
class InfoFixture : public ReduceFixture {
 protected:
    using json = nlohmann::json;

    RunResult info(const Arguments& more = {}) const {
        Arguments all{"info", in_};
        all.insert(all.end(), more.begin(), more.end());
        return runOffmap(all);
    }

    /// What --json prints; it must be all that is printed.
    json facts(const Arguments& more = {}, int exitCode = 0) const {
        Arguments all{"--json"};
        all.insert(all.end(), more.begin(), more.end());
        const RunResult run = info(all);
        EXPECT_EQ(run.exitCode, exitCode) << testing::PrintToString(run);
        return json::parse(run.out);
    }

    /// The options that are missing, "" for what no option gives.
    static std::vector<std::string> missing(const json& facts) {
        std::vector<std::string> options;
        for (const json& step : facts.at("missing")) {
            const json& option = step.at("option");
            options.push_back(option.is_null() ? "" : option.get<std::string>());
        }
        return options;
    }

    static json sensor(const json& facts, const std::string& label) {
        for (const json& sensor : facts.at("sensors")) {
            if (sensor.at("label") == label) return sensor;
        }
        ADD_FAILURE() << "no sensor " << label;
        return {};
    }

    /// Actions and frames of a robot that drives straight on, a cloud in each.
    static Objects drivenFrames(SimulatedRobot& robot, int frames) {
        Objects entries;
        for (int i = 0; i < frames; ++i) {
            const double step = i == 0 ? 0.0 : 0.05;  // [m]
            robot.pose = robot.pose + mrpt::poses::CPose3D(step, 0, 0, 0, 0, 0);
            mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
            model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
            mrpt::obs::CActionRobotMovement2D action;
            action.timestamp = robot.now;
            action.computeFromOdometry(mrpt::poses::CPose2D(step, 0, 0), model);
            auto actions = mrpt::obs::CActionCollection::Create();
            actions->insert(action);
            auto frame = mrpt::obs::CSensoryFrame::Create();
            frame->push_back(robot.cloud());
            entries.insert(entries.end(), {actions, frame});
            robot.wait(0.2);
        }
        return entries;
    }

    /// Odometry and a cloud every 0.2 s of a robot that drives straight on.
    static Observations drivenOdometry(SimulatedRobot& robot, int clouds) {
        Observations log;
        for (int i = 0; i < clouds; ++i) {
            const auto odometry = robot.odometry();
            odometry->odometry = mrpt::poses::CPose2D(7 + 0.05 * i, -3, 0);
            log.insert(log.end(), {odometry, robot.cloud()});
            robot.pose = robot.pose + mrpt::poses::CPose3D(0.05, 0, 0, 0, 0, 0);
            robot.wait(0.2);
        }
        return log;
    }
};

}  // namespace offmap::test
