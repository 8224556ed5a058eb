// SPDX-License-Identifier: BSD-3-Clause
#include "LogPoses.h"

#include <offmap/rawlog/DeadReckoning.h>
#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/rawlog/OdometryMotion.h>

#include <fmt/format.h>

#include <algorithm>

namespace offmap::rawlog {
namespace {

std::vector<StampedPose> fromActions(const ActionSurvey& actions, DeadReckoning reckoning) {
    for (const MotionStep& step : actions.steps) reckoning.move(step);
    return reckoning.takePoses();
}

std::vector<StampedPose> fromOdometry(std::vector<StampedOdometry> readings,
                                      DeadReckoning reckoning, const OdometryConfig& noise) {
    std::ranges::stable_sort(readings, {}, &StampedOdometry::time);
    // From the first reading to itself: finite or not, the vehicle has not moved yet.
    const StampedOdometry* before = &readings.front();
    for (const StampedOdometry& reading : readings) {
        reckoning.move(motionBetween(*before, reading, noise));
        before = &reading;
    }
    return reckoning.takePoses();
}

/// Of movements that lead to no frame with a time, no pose can be had.
bool tellPoses(const ActionSurvey& actions) {
    return actions.movements > 0 && std::ranges::any_of(actions.steps, [](const MotionStep& step) {
               return step.time.has_value();
           });
}

}  // namespace

std::string LogPoses::describe() const {
    const char* const what = origin == PoseOrigin::RobotPoses ? "robot pose"
                             : origin == PoseOrigin::Actions  ? "movement"
                                                              : "odometry reading";
    return fmt::format("{}: {} {}{}", name, grouped(count), what, count == 1 ? "" : "s");
}

std::vector<LogPoses> posesOffered(const LogSurvey& survey) {
    std::vector<LogPoses> offered;
    for (const auto& [label, poses] : survey.poses) {
        offered.push_back({PoseOrigin::RobotPoses, label, poses.size()});
    }
    if (tellPoses(survey.actions)) {
        offered.push_back({PoseOrigin::Actions, "actions", survey.actions.movements});
    }
    for (const auto& [label, readings] : survey.odometry) {
        offered.push_back({PoseOrigin::Odometry, label, readings.size()});
    }
    return offered;
}

std::vector<StampedPose> posesOf(const LogPoses& offered, const LogSurvey& survey,
                                 const Config& config, const mrpt::math::TPose2D& initialInMap) {
    if (offered.origin == PoseOrigin::RobotPoses) return survey.poses.at(offered.name);
    DeadReckoning reckoning(initialInMap, config.pose.sigmaPosition, config.pose.sigmaYaw);
    if (offered.origin == PoseOrigin::Actions) {
        return fromActions(survey.actions, std::move(reckoning));
    }
    return fromOdometry(survey.odometry.at(offered.name), std::move(reckoning), config.odometry);
}

}  // namespace offmap::rawlog
