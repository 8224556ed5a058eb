// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class BadPoses : public ReduceFixture {
 protected:
    /// A log of two clouds, the pose before the second one altered.
    template <class Alter>
    void writeLogWithPose(Alter&& alter) {
        SimulatedRobot robot;
        Observations log{robot.localisation(), robot.cloud()};
        robot.wait(10);
        const auto pose = robot.localisation();
        alter(*pose);
        log.insert(log.end(), {pose, robot.cloud()});
        writeLog(in_, log);
    }

    /// The first cloud is reduced, the second one copied for that reason.
    void expectSecondKeptWhole(const std::string& reason) {
        const auto report = folder_ / "report.json";
        const RunResult run = reduce({"--report", report, "--strict"});
        EXPECT_EQ(run.exitCode, 3) << testing::PrintToString(run);
        const auto json = nlohmann::json::parse(readFile(report));
        EXPECT_EQ(json["totals"]["scans_not_reduced"], (nlohmann::json{{reason, 1}}));
        EXPECT_TRUE(json["scans"][0]["not_reduced"].is_null());
        EXPECT_EQ(json["scans"][1]["not_reduced"], reason);
        std::string words = reason;
        std::replace(words.begin(), words.end(), '_', ' ');
        EXPECT_THAT(run.out, HasSubstr("kept whole: 1 " + words));

        const auto in = entriesOf(in_), out = entriesOf(out_);
        ASSERT_EQ(in.size(), 4U);
        ASSERT_EQ(out.size(), 4U);
        EXPECT_NE(out[1].bytes, in[1].bytes);
        EXPECT_EQ(out[3].bytes, in[3].bytes);
        EXPECT_EQ(reduce({"--force"}).exitCode, 0) << "without --strict";
    }
};

TEST_F(BadPoses, logWithoutPoseIsRefused) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.cloud()});
    expectRefusal(reduceArguments(), 2,
                  AllOf(HasSubstr(in_.string() + " holds no robot pose"), HasSubstr("--pose "),
                        HasSubstr("--keep-going")));
}

TEST_F(BadPoses, scanInAGapOfAMovingRobotIsKept) {
    SimulatedRobot robot;
    Observations log{robot.localisation(), robot.cloud()};
    robot.wait(5);
    robot.pose.x(3);
    log.push_back(robot.cloud());
    robot.wait(5);
    robot.pose.x(4);
    log.push_back(robot.localisation());
    writeLog(in_, log);
    const auto report = folder_ / "report.json";
    EXPECT_EQ(reduce({"--report", report}).exitCode, 0);
    const auto json = nlohmann::json::parse(readFile(report));
    EXPECT_EQ(json["totals"]["scans_not_reduced"], (nlohmann::json{{"pose_too_old", 1}}));
    EXPECT_EQ(entriesOf(out_).at(2).bytes, entriesOf(in_).at(2).bytes);
    EXPECT_EQ(reduce({"--force", "--strict"}).exitCode, 3);
}

TEST_F(BadPoses, scanInAGapOfAStandingRobotIsReduced) {
    SimulatedRobot robot;
    Observations log{robot.localisation()};
    robot.wait(60);
    log.push_back(robot.cloud());
    robot.wait(60);
    log.push_back(robot.localisation());
    writeLog(in_, log);
    EXPECT_EQ(reduce({"--strict"}).exitCode, 0);
    EXPECT_LT(returnsOf(*observationsOf(out_).at(1)).size(),
              returnsOf(*observationsOf(in_).at(1)).size() * 3 / 4);
}

TEST_F(BadPoses, posesThatAreNotANumberAreNotUsed) {
    writeLogWithPose(
        [](auto& pose) { pose.pose.mean.x(std::numeric_limits<double>::quiet_NaN()); });
    expectSecondKeptWhole("pose_not_finite");
}

TEST_F(BadPoses, covarianceThatIsNotFiniteIsNotUsed) {
    writeLogWithPose(
        [](auto& pose) { pose.pose.cov(3, 3) = std::numeric_limits<double>::infinity(); });
    expectSecondKeptWhole("pose_not_finite");
}

TEST_F(BadPoses, covarianceThatIsNotPsdIsNotUsed) {
    writeLogWithPose([](auto& pose) { pose.pose.cov(0, 1) = pose.pose.cov(1, 0) = 1; });
    expectSecondKeptWhole("covariance_not_psd");
}

TEST_F(BadPoses, uselessCovarianceIsNotUsed) {
    writeLogWithPose([](auto& pose) { pose.pose.cov(0, 0) = pose.pose.cov(1, 1) = 100; });
    expectSecondKeptWhole("pose_too_uncertain");
}

class PoseLabels : public ReduceFixture {
 protected:
    PoseLabels() {
        SimulatedRobot robot;
        Observations log{robot.localisation("AMCL"), robot.cloud()};
        robot.pose.x(7);  // far off the truth
        log.push_back(robot.localisation("GPS"));
        writeLog(in_, log);
    }
};

TEST_F(PoseLabels, severalAreListed) {
    expectRefusal(
        reduceArguments(), 1,
        AllOf(HasSubstr(in_.string()), HasSubstr("--pose-label"), HasSubstr("AMCL, GPS")));
}

TEST_F(PoseLabels, theChosenOneIsUsed) {
    const RunResult amcl = reduce({"--pose-label", "AMCL"});
    EXPECT_EQ(amcl.exitCode, 0);
    EXPECT_THAT(amcl.out, HasSubstr("AMCL: 1 robot pose"));
    const size_t left = returnsOf(*observationsOf(out_).at(1)).size();
    EXPECT_EQ(reduce({"--pose-label", "GPS", "--force"}).exitCode, 0);
    EXPECT_LT(left, returnsOf(*observationsOf(out_).at(1)).size());
}

TEST_F(PoseLabels, unknownOneIsRefused) {
    expectRefusal(reduceArguments({"--pose-label", "SLAM"}), 1,
                  AllOf(HasSubstr("'SLAM'"), HasSubstr("AMCL, GPS")));
}

TEST_F(PoseLabels, unknownSensorIsRefused) {
    expectRefusal(reduceArguments({"--sensor", "LIDAR", "--pose-label", "AMCL"}), 1,
                  AllOf(HasSubstr("'LIDAR'"), HasSubstr("CLOUD")));
}

TEST_F(PoseLabels, fixedPoseNeedsNoLabel) {
    const RunResult run = reduce({"--pose", "2.0,2.5,17.2"});  // 0.3 rad
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_LT(returnsOf(*observationsOf(out_).at(1)).size(),
              returnsOf(*observationsOf(in_).at(1)).size() * 3 / 4);
}

TEST_F(PoseLabels, incompleteFixedPoseIsRefused) {
    for (const char* pose : {"2.0,2.5", "2.0,2.5,17,1", "2.0,2.5,east", "nan,0,0"}) {
        SCOPED_TRACE(pose);
        expectRefusal(reduceArguments({"--pose", pose}), 1,
                      AllOf(HasSubstr("--pose"), HasSubstr("3 numbers, x,y,yaw_deg")));
    }
}

// As from a variable that is not set.
TEST_F(PoseLabels, emptyValuesAreRefused) {
    for (const char* option : {"--pose", "--pose-label", "--map-origin", "--trajectory",
                               "--initial-pose", "--pose-delay", "--pose-sigma"}) {
        expectRefusal(reduceArguments({option, ""}), 1,
                      AllOf(HasSubstr(std::string(option) + ": "), HasSubstr("is empty")));
    }
}

TEST_F(PoseLabels, sensorWithoutScansIsRefused) {
    writeLog(in_, Observations{SimulatedRobot().odometry(), SimulatedRobot().cloud()});
    expectRefusal(reduceArguments({"--sensor", "ODOMETRY", "--pose", "0,0,0"}), 1,
                  AllOf(HasSubstr("no 3D scan labelled 'ODOMETRY'"), HasSubstr("CLOUD")));
}

TEST_F(PoseLabels, wrongSigmasAreRefused) {
    for (const char* sigmas : {"0.05", "0.05,1,1", "-0.05,1", "0.05,wide"}) {
        SCOPED_TRACE(sigmas);
        expectRefusal(reduceArguments({"--pose", "2,2.5,17", "--pose-sigma", sigmas}), 1,
                      testing::AnyOf(HasSubstr("--pose-sigma"), HasSubstr("pose.sigma")));
    }
}

TEST_F(PoseLabels, sigmasOfNothingAreRefused) {
    expectRefusal(reduceArguments({"--pose-label", "AMCL", "--pose-sigma", "0.05,1"}), 1,
                  AllOf(HasSubstr("--pose-sigma"), HasSubstr("--trajectory")));
}

TEST_F(PoseLabels, wrongInitialPosesAreRefused) {
    for (const char* pose : {"1,2", "1,2,3,4", "1,2,north", "1,2,inf"}) {
        SCOPED_TRACE(pose);
        expectRefusal(reduceArguments({"--initial-pose", pose}), 1,
                      AllOf(HasSubstr("--initial-pose"), HasSubstr("3 numbers, x,y,yaw_deg")));
    }
}

TEST_F(PoseLabels, wrongDelaysAreRefused) {
    for (const char* delay : {"soon", "1,2", "nan", "0.1s", "1e11"}) {
        SCOPED_TRACE(delay);
        expectRefusal(reduceArguments({"--pose-label", "AMCL", "--pose-delay", delay}), 1,
                      HasSubstr("--pose-delay"));
    }
}

TEST_F(PoseLabels, waysToGivePosesExcludeEachOther) {
    const Path file = folder_ / "run.tum";
    writeFile(file, "1700000000 2 2.5 0 0 0 0 1\n");
    for (const Arguments& pair : {Arguments{"--pose", "1,2,3", "--trajectory", file},
                                  Arguments{"--pose", "1,2,3", "--initial-pose", "1,2,3"},
                                  Arguments{"--pose", "1,2,3", "--pose-delay", "1"},
                                  Arguments{"--pose", "1,2,3", "--pose-label", "AMCL"},
                                  Arguments{"--trajectory", file, "--initial-pose", "1,2,3"},
                                  Arguments{"--trajectory", file, "--pose-label", "AMCL"}}) {
        SCOPED_TRACE(testing::PrintToString(pair));
        expectRefusal(reduceArguments(pair), 1,
                      AllOf(HasSubstr(pair[0]), HasSubstr(pair[2]), HasSubstr("excludes")));
    }
}

TEST_F(PoseLabels, badTrajectoriesAreRefused) {
    const Path file = folder_ / "run.tum";
    for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
             {"", "holds no pose"},
             {"1 2 3\n", ":1: 3 numbers"},
             {"# t\n1 0 0 0 0 0 0 0\n", ":2: qx qy qz qw has a length of 0"},
             {"1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0\n", ":2: 7 numbers, but 8 before"},
             {"1 0 0 0 0 0 0 x\n", ":1: 'x' is not a number"},
             {"-1 0 0 0 0 0 0\n", ":1: -1 is no time"}}) {
        SCOPED_TRACE(text);
        writeFile(file, text);
        expectRefusal(reduceArguments({"--trajectory", file}), 2,
                      AllOf(HasSubstr(file.string()), HasSubstr(message)));
    }
    expectRefusal(reduceArguments({"--trajectory", folder_ / "none.tum"}), 2,
                  HasSubstr("none.tum: cannot read the trajectory: No such file"));
    expectRefusal(reduceArguments({"--trajectory", folder_.path()}), 2, HasSubstr("directory"));
}

TEST_F(PoseLabels, trajectoryIsNotOverwritten) {
    writeFile(out_, "1700000000 2 2.5 0 0 0 0 1\n");
    expectRefusal(reduceArguments({"--trajectory", out_, "--force"}), 1, HasSubstr("--trajectory"));
}

}  // namespace
