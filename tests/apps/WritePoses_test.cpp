// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "../support/Scans.h"
#include "ReduceFixture.h"

#include <offmap/core/SensorPose.h>

#include <Eigen/Cholesky>
#include <mrpt/math/wrap2pi.h>

namespace {

using namespace offmap::test;
using mrpt::obs::CObservationRobotPose;
using mrpt::poses::CPose3D;
using testing::AllOf;
using testing::HasSubstr;

class WritePoses : public ReduceFixture {
 protected:
    /// A pose that is off, and says how far it may be.
    static auto vagueLocalisation(const SimulatedRobot& robot, const CPose3D& error) {
        auto obs = robot.localisation();
        obs->pose.mean = CPose3D(robot.pose.x() + error.x(), robot.pose.y() + error.y(), 0,
                                 robot.pose.yaw() + error.yaw(), 0, 0);
        obs->pose.cov.setZero();
        obs->pose.cov(0, 0) = obs->pose.cov(1, 1) = 0.1 * 0.1;
        obs->pose.cov(3, 3) = mrpt::DEG2RAD(3.0) * mrpt::DEG2RAD(3.0);
        return obs;
    }

    static Observations vagueLog(SimulatedRobot& robot, int seconds = 2) {
        Observations log;
        for (int second = 0; second < seconds; ++second) {
            const double side = second % 2 == 0 ? 1 : -1;
            log.push_back(vagueLocalisation(robot, {0.1 * side, -0.08, 0, 0.05 * side, 0, 0}));
            robot.wait(0.1);
            const Observations scans{robot.vlp16(), robot.imu(), robot.cloud()};
            log.insert(log.end(), scans.begin(), scans.end());
            robot.wait(0.9);
        }
        return log;
    }

    RunResult reduceAligned(const Arguments& more = {}) const {
        Arguments all{"--method", "aligned", "--force"};
        all.insert(all.end(), more.begin(), more.end());
        const RunResult run = reduce(all);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return run;
    }

    /// The poses under a label, in the log's order.
    static std::vector<CObservationRobotPose::Ptr> posesIn(const Path& log,
                                                           const std::string& label) {
        std::vector<CObservationRobotPose::Ptr> poses;
        for (const auto& obs : observationsOf(log)) {
            const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(obs);
            if (pose && pose->sensorLabel == label) poses.push_back(pose);
        }
        return poses;
    }

    static size_t returnsIn(const Path& log) {
        size_t returns = 0;
        for (const auto& obs : observationsOf(log)) {
            if (is3dScan(*obs)) returns += returnsOf(*obs).size();
        }
        return returns;
    }
};

bool isPose(const LogEntry& entry, const std::string& label) {
    const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(entry.object);
    return pose && pose->sensorLabel == label;
}

TEST_F(WritePoses, addsEntriesAndChangesNone) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 2));
    const Path removed = folder_ / "removed.rawlog";
    reduceAligned({"--removed", removed});
    const auto plain = entriesOf(out_);
    const std::string plainRemoved = readFile(removed);
    reduceAligned({"--removed", removed, "--write-poses"});
    const auto all = entriesOf(out_);
    std::vector<LogEntry> others;
    size_t poses = 0;
    for (const LogEntry& entry : all) {
        if (!isPose(entry, "OFFMAP_POSE")) {
            others.push_back(entry);
            continue;
        }
        ++poses;
        // Behind the first observation of its turn, at its time.
        const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation>(others.back().object);
        const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(entry.object);
        EXPECT_TRUE(is3dScan(*scan)) << scan->sensorLabel;
        EXPECT_EQ(pose->timestamp, scan->timestamp);
    }
    EXPECT_EQ(poses, 6U);  // a VLP-16's, a cloud's and a sweep's a second
    ASSERT_EQ(others.size(), plain.size());
    for (size_t i = 0; i < plain.size(); ++i) {
        EXPECT_TRUE(others[i].bytes == plain[i].bytes) << "entry " << i;
    }
    EXPECT_TRUE(readFile(removed) == plainRemoved);
}

TEST_F(WritePoses, addsThemToTheFramesThatTurnsBeginIn) {
    SimulatedRobot robot;
    writeLog(in_, inFrames(secondsOf(robot, 2)));
    reduceAligned();
    const auto plain = entriesOf(out_);
    reduceAligned({"--write-poses=REFINED"});
    const auto all = entriesOf(out_);
    EXPECT_EQ(posesIn(out_, "REFINED").size(), 6U);
    ASSERT_EQ(all.size(), plain.size());
    for (size_t i = 0; i < plain.size(); ++i) {
        const Observations before = observationsOf(plain[i]), after = observationsOf(all[i]);
        ASSERT_GE(after.size(), before.size());
        for (size_t m = 0; m < before.size(); ++m) {
            EXPECT_TRUE(bytesOf(*after[m]) == bytesOf(*before[m])) << before[m]->sensorLabel;
        }
        for (size_t m = before.size(); m < after.size(); ++m) {
            EXPECT_EQ(after[m]->sensorLabel, "REFINED");
        }
        EXPECT_EQ(all[i].bytes == plain[i].bytes, after.size() == before.size());
    }
}

// The vehicle's, not the sensors', which stand up to 0.22 m beside it.
TEST_F(WritePoses, tellWhereTheVehicleTrulyWas) {
    SimulatedRobot robot;
    writeLog(in_, vagueLog(robot, 4));
    reduceAligned({"--write-poses"});
    const auto poses = posesIn(out_, "OFFMAP_POSE");
    ASSERT_EQ(poses.size(), 8U);
    for (const auto& obs : poses) {
        const auto& [mean, covariance] = std::tie(obs->pose.mean, obs->pose.cov);
        const double dx = mean.x() - robot.pose.x(), dy = mean.y() - robot.pose.y();
        const double turn = mrpt::math::wrapToPi(mean.yaw() - robot.pose.yaw());
        // Walls of 2 cm, ranges of 5 mm: a fifth of the 0.13 m and 3 degrees that it was off.
        EXPECT_LT(std::hypot(dx, dy), 0.025);
        EXPECT_LT(std::abs(turn), mrpt::DEG2RAD(0.6));
        const Eigen::Vector3d error(dx, dy, turn);
        const Eigen::Matrix3d stated = offmap::core::groundBlock(covariance);
        EXPECT_LT(error.dot(stated.ldlt().solve(error)), 21.1);  // once in 10,000
        EXPECT_LT(std::sqrt(stated(0, 0)), 0.05);
        EXPECT_EQ(mean.z(), 0);
    }
}

TEST_F(WritePoses, tellHowTheVehicleLeans) {
    SimulatedRobot robot;
    robot.pose = CPose3D(2.0, 2.5, 0, 0.3, -0.01, 0.015);
    writeLog(in_, vagueLog(robot));
    reduceAligned({"--write-poses"});
    const auto poses = posesIn(out_, "OFFMAP_POSE");
    ASSERT_EQ(poses.size(), 4U);
    for (const auto& obs : poses) {
        // Walls stand upright: a segment of 1 m with 5 mm of noise leans by 5 mrad, many by less.
        EXPECT_NEAR(obs->pose.mean.pitch(), -0.01, 0.004);
        EXPECT_NEAR(obs->pose.mean.roll(), 0.015, 0.004);
        EXPECT_GT(obs->pose.cov(4, 4), 0);
        EXPECT_GT(obs->pose.cov(5, 5), 0);
    }
}

TEST_F(WritePoses, serveASecondRunAtLeastAsWell) {
    SimulatedRobot robot;
    robot.pose = CPose3D(2.0, 2.5, 0, 0.3, -0.01, 0.015);
    writeLog(in_, vagueLog(robot));
    reduceAligned({"--write-poses"});
    const size_t kept = returnsIn(out_);
    Observations again = observationsOf(in_);
    for (const auto& pose : posesIn(out_, "OFFMAP_POSE")) again.push_back(pose);
    writeLog(in_, again);
    const RunResult run = reduceAligned({"--pose-label", "OFFMAP_POSE", "--strict"});
    EXPECT_LE(returnsIn(out_), kept);
    EXPECT_LT(kept, returnsIn(in_) * 3 / 4);
    EXPECT_THAT(run.out, testing::Not(HasSubstr("suspect")));
}

TEST_F(WritePoses, ofScansKeptWholeAreNone) {
    SimulatedRobot robot;
    const auto wrong = robot.localisation();
    wrong->pose.mean = CPose3D(3.4, 1.1, 0, 2.0, 0, 0);
    writeLog(in_, Observations{wrong, robot.cloud()});
    const RunResult run = reduceAligned({"--write-poses"});
    EXPECT_THAT(run.out, HasSubstr("kept whole: 1 pose does not fit"));
    EXPECT_EQ(entriesOf(out_).size(), 2U);
}

TEST_F(WritePoses, needAMethodThatRefinesThem) {
    writeLog(in_, smallLog());
    for (const char* method : {"paper", "probabilistic"}) {
        expectRefusal(reduceArguments({"--method", method, "--write-poses"}), 1,
                      AllOf(HasSubstr("--write-poses"), HasSubstr("--method aligned")));
    }
}

TEST_F(WritePoses, needALabelOfTheirOwn) {
    writeLog(in_, smallLog());
    for (const char* label : {"LOCALIZATION", "CLOUD"}) {
        expectRefusal(reduceArguments({"--method", "aligned", "--write-poses", label}), 1,
                      AllOf(HasSubstr(in_), HasSubstr(label), HasSubstr("--write-poses LABEL")));
    }
    expectRefusal(reduceArguments({"--method", "aligned", "--write-poses", "actions"}), 1,
                  HasSubstr("--pose-label"));
}

}  // namespace
