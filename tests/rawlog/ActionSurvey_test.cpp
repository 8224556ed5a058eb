// SPDX-License-Identifier: BSD-3-Clause
#include "../support/LogFiles.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/DeadReckoning.h>
#include <offmap/rawlog/LogSurvey.h>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <limits>

namespace offmap::rawlog {
namespace {

using mrpt::obs::CActionCollection;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;

mrpt::Clock::time_point second(double seconds) { return mrpt::Clock::fromDouble(1.7e9 + seconds); }

LogSurvey surveyed(const std::filesystem::path& log) {
    RawlogReader reader(log);
    return surveyLog(reader, Config(), std::numeric_limits<uint64_t>::max(), [] {});
}

std::shared_ptr<CObservationOdometry> reading(std::optional<double> seconds,
                                              const std::string& label = "ODOMETRY") {
    auto odometry = CObservationOdometry::Create();
    odometry->sensorLabel = label;
    odometry->timestamp = seconds ? second(*seconds) : INVALID_TIMESTAMP;
    odometry->odometry = {seconds.value_or(-1), 2, 0.5};
    return odometry;
}

/// A frame of observations at these times; none: an observation without a time.
CSensoryFrame::Ptr frame(const std::vector<std::optional<double>>& seconds) {
    auto observations = CSensoryFrame::Create();
    for (const auto& time : seconds) observations->push_back(reading(time));
    return observations;
}

/// A movement by so many metres; none: actions of other kinds only.
CActionCollection::Ptr ahead(std::optional<double> metres) {
    auto actions = CActionCollection::Create();
    if (!metres) return actions;
    mrpt::obs::CActionRobotMovement2D movement;
    movement.computeFromOdometry(mrpt::poses::CPose2D(*metres, 0, 0), {});
    actions->insert(movement);
    return actions;
}

class ActionSurvey : public testing::Test {
 protected:
    LogSurvey surveyOf(const test::Objects& entries) {
        test::writeLog(folder_ / "in.rawlog", entries);
        return surveyed(folder_ / "in.rawlog");
    }

    /// Time after `second(0)` and x of the poses that the actions lead to.
    std::vector<std::pair<double, double>> placesOf(const test::Objects& entries) {
        DeadReckoning reckoning({0, 0, 0}, 0, 0);
        for (const MotionStep& step : surveyOf(entries).actions.steps) reckoning.move(step);
        std::vector<std::pair<double, double>> places;
        for (const StampedPose& pose : reckoning.poses()) {
            places.emplace_back(std::round(mrpt::Clock::toDouble(pose.time) - 1.7e9),
                                std::round(1e6 * pose.vehicleInMap.x) * 1e-6);
        }
        return places;
    }

    using Places = std::vector<std::pair<double, double>>;
    test::TemporaryFolder folder_;
};

TEST_F(ActionSurvey, poseAfterAnActionHoldsForTheFrameThatFollows) {
    EXPECT_EQ(placesOf({ahead(1), frame({5, 6}), ahead(2), frame({7})}), (Places{{5, 1}, {7, 3}}));
}

TEST_F(ActionSurvey, framesBeforeAnyActionHaveTheInitialPose) {
    EXPECT_EQ(placesOf({frame({4}), ahead(1), frame({5})}), (Places{{4, 0}, {5, 1}}));
}

TEST_F(ActionSurvey, framesAfterOneActionShareItsPose) {
    EXPECT_EQ(placesOf({ahead(1), frame({5}), frame({6})}), (Places{{5, 1}, {6, 1}}));
}

TEST_F(ActionSurvey, actionsWithoutAFrameAreComposed) {
    EXPECT_EQ(placesOf({ahead(1), ahead(2), frame({5})}), (Places{{5, 3}}));
}

TEST_F(ActionSurvey, firstValidTimeOfTheFrameCounts) {
    EXPECT_EQ(placesOf({ahead(1), frame({{}, 6, 5})}), (Places{{6, 1}}));
    EXPECT_EQ(placesOf({ahead(1), frame({{}}), ahead(1), frame({7})}), (Places{{7, 2}}));
}

TEST_F(ActionSurvey, actionsWithoutAMovementLeaveTheRobotWhereItIs) {
    EXPECT_EQ(placesOf({ahead(1), frame({5}), ahead({}), frame({6})}), (Places{{5, 1}, {6, 1}}));
}

// MRPT draws the particles of such an action when it is read.
TEST_F(ActionSurvey, particlesAreDrawnAlikeEachTime) {
    mrpt::obs::CActionRobotMovement2D::TMotionModelOptions particles;
    particles.modelSelection = mrpt::obs::CActionRobotMovement2D::mmThrun;
    mrpt::obs::CActionRobotMovement2D movement;
    movement.computeFromOdometry(mrpt::poses::CPose2D(0.5, 0.1, 0.2), particles);
    auto actions = CActionCollection::Create();
    actions->insert(movement);
    const auto first = surveyOf({actions}).actions.steps.at(0);
    const auto second = surveyOf({actions}).actions.steps.at(0);
    EXPECT_EQ(first.vehicleInPrevious, second.vehicleInPrevious);
    EXPECT_EQ(first.groundCovariance, second.groundCovariance);
    EXPECT_GT(first.groundCovariance[0], 0);
    EXPECT_NEAR(first.vehicleInPrevious.x, 0.5, 5 * std::sqrt(first.groundCovariance[0]));
}

TEST_F(ActionSurvey, entriesAreCounted) {
    const LogSurvey survey =
        surveyOf({frame({1}), ahead(1), frame({2}), ahead({}), frame({3}), frame({4})});
    EXPECT_EQ(survey.actions.collections, 2U);
    EXPECT_EQ(survey.actions.movements, 1U);
    EXPECT_EQ(survey.actions.frames, 4U);
}

TEST_F(ActionSurvey, odometryIsKeptByLabelIfItHasATime) {
    const LogSurvey survey =
        surveyOf({reading(1, "WHEELS"), reading({}, "WHEELS"), frame({2}), reading(3, "WHEELS")});
    ASSERT_EQ(survey.odometry.size(), 2U);
    ASSERT_EQ(survey.odometry.at("WHEELS").size(), 2U);
    EXPECT_EQ(survey.odometry.at("WHEELS")[1].time, second(3));
    EXPECT_EQ(survey.odometry.at("WHEELS")[1].vehicleInOdometry, mrpt::math::TPose2D(3, 2, 0.5));
    EXPECT_EQ(survey.odometry.at("ODOMETRY").size(), 1U);
}

TEST_F(ActionSurvey, timesOfScansAreThoseOf3dSensorsAlone) {
    test::SimulatedRobot robot;
    test::Objects entries{robot.odometry()};
    robot.wait(5);
    const auto begin = robot.now;
    entries.push_back(robot.cloud());
    robot.wait(5);
    entries.push_back(robot.cloud());
    const auto end = robot.now;
    robot.wait(5);
    entries.push_back(robot.imu());
    const auto times = surveyOf(entries).scanTimes();
    ASSERT_TRUE(times);
    EXPECT_EQ(times->begin, begin);
    EXPECT_EQ(times->end, end);
    EXPECT_FALSE(surveyOf({robot.imu()}).scanTimes());
}

// Real logs: the track ends where MRPT's own composition of the means does, and grows uncertain.
void expectCompositionOfMrpt(const std::string& name, size_t movements) {
    const std::filesystem::path log = "/usr/share/mrpt/datasets/" + name;
    mrpt::poses::CPose3D moved, expected;  // the last action of a log may lead to no frame
    size_t found = 0;
    for (const test::LogEntry& entry : test::entriesOf(log)) {
        const auto actions = std::dynamic_pointer_cast<CActionCollection>(entry.object);
        mrpt::poses::CPose3D increment;
        if (actions && actions->getFirstMovementEstimationMean(increment)) {
            moved = moved + increment;
            ++found;
        }
        if (std::dynamic_pointer_cast<CSensoryFrame>(entry.object)) expected = moved;
    }
    EXPECT_EQ(found, movements);

    DeadReckoning reckoning({0, 0, 0}, 0.05, 0.02);
    const LogSurvey survey = surveyed(log);
    EXPECT_EQ(survey.actions.movements, movements);
    for (const MotionStep& step : survey.actions.steps) reckoning.move(step);
    ASSERT_EQ(reckoning.poses().size(), survey.actions.frames);
    const auto end = reckoning.poses().back().vehicleInMap, mrptEnd = expected.asTPose();
    // Hundreds of steps, rounded to 1e-16 of some 100 m each.
    for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(end[i], mrptEnd[i], 1e-10) << i;

    // The lever's Jacobian has the determinant 1, so the volume of the ellipsoid never shrinks;
    // sums over a hundred square metres are rounded to 1e-12 of them.
    double volume = 0, headingVariance = 0;
    for (const StampedPose& pose : reckoning.poses()) {
        ASSERT_FALSE(pose.fault);
        const Eigen::Matrix3d covariance = matrixOf(pose.groundCovariance);
        EXPECT_GE(covariance.determinant(), volume * (1 - 1e-9));
        EXPECT_GE(covariance(2, 2), headingVariance);
        volume = covariance.determinant(), headingVariance = covariance(2, 2);
    }
    EXPECT_GT(headingVariance, 0.02 * 0.02);
}

TEST_F(ActionSurvey, realLogsAreComposedAsByMrpt) {
    expectCompositionOfMrpt("localization_demo.rawlog", 37);
    expectCompositionOfMrpt("2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog", 224);
    expectCompositionOfMrpt("kf-slam_6D_demo.rawlog", 600);
}

}  // namespace
}  // namespace offmap::rawlog
