// SPDX-License-Identifier: BSD-3-Clause
#include "../support/RotatingMaker.h"
#include "InfoFixture.h"

#include <mrpt/obs/CObservationPointCloud.h>

namespace {

using namespace offmap::test;
using testing::ElementsAre;

/// Somebody who has a log and a map, asks `offmap info` what to do, and does it: runs the command
/// line that it prints, in a shell, with only the placeholders filled in.
class StrangersPath : public InfoFixture {
 protected:
    static void replace(std::string& text, const std::string& what, const std::string& by) {
        const size_t at = text.find(what);
        if (at != std::string::npos) text.replace(at, what.size(), by);
    }

    /// \param pose "x,y,yaw_deg" of the robot when the log begins
    void expectReduction(const std::string& pose = "2,2.5,17.188734") {
        const json before = facts();
        EXPECT_TRUE(before.at("has_scans_to_reduce"));
        std::string line = before.at("command_line");
        SCOPED_TRACE(line);
        replace(line, "offmap", offmapBinary());
        replace(line, "X,Y,YAW_DEG", pose);
        replace(line, "[ELEVATIONS_DEG]", rotatingElevationsText());
        replace(line, "MAP", map_.string());
        const Path report = folder_ / "report.json";
        line += " --report " + report.string();
        const RunResult run = runProgram({"/bin/bash", "-c", line}, {.folder = folder_.path()});
        ASSERT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        const json totals = json::parse(readFile(report)).at("totals");
        EXPECT_GT(totals.at("points_removed"), 0);
        // Half of what stands upright in the office is wall, at least.
        EXPECT_GT(2 * totals.at("points_removed").get<double>(),
                  totals.at("points_on_vertical_segments").get<double>());
        EXPECT_EQ(totals.at("columns_without_pose"), 0);
        EXPECT_TRUE(std::filesystem::exists(folder_ / "in.reduced.rawlog"));
    }

    template <class Scan>
    void expectReductionBetweenPoses(const Scan& makeScan) {
        SimulatedRobot robot;
        Observations log{robot.localisation()};
        robot.wait(0.02);
        log.push_back(makeScan(robot));
        robot.wait(0.2);
        log.push_back(robot.localisation());
        writeLog(in_, log);
        expectReduction();
    }
};

TEST_F(StrangersPath, vlp16) {
    expectReductionBetweenPoses([](SimulatedRobot& robot) { return robot.vlp16(); });
}

TEST_F(StrangersPath, vlp16OfTwoReturns) {
    expectReductionBetweenPoses([](SimulatedRobot& robot) { return robot.vlp16Dual(); });
}

TEST_F(StrangersPath, hdl32) {
    expectReductionBetweenPoses([](SimulatedRobot& robot) { return robot.hdl32(); });
}

TEST_F(StrangersPath, pointCloud) {
    expectReductionBetweenPoses([](SimulatedRobot& robot) { return robot.cloud(); });
}

TEST_F(StrangersPath, rotatingScanOfAnUnknownModel) {
    expectReductionBetweenPoses([](SimulatedRobot& robot) { return robot.rotatingScan(); });
}

TEST_F(StrangersPath, depthCamera) {
    expectReductionBetweenPoses([](SimulatedRobot& robot) { return robot.depthCamera(); });
}

TEST_F(StrangersPath, turnedScanner) {
    SimulatedRobot robot;
    Observations log{robot.localisation()};
    const Observations sweep = robot.sweep();
    log.insert(log.end(), sweep.begin(), sweep.end());
    log.push_back(robot.localisation());
    writeLog(in_, log);
    expectReduction();
}

TEST_F(StrangersPath, allSensorsAtOnce) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 1));
    expectReduction();
}

TEST_F(StrangersPath, noPoses) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.cloud()});
    expectReduction();
}

TEST_F(StrangersPath, actionsAndFrames) {
    SimulatedRobot robot;
    writeLog(in_, drivenFrames(robot, 5));
    expectReduction();
}

TEST_F(StrangersPath, odometryOnly) {
    SimulatedRobot robot;
    writeLog(in_, drivenOdometry(robot, 5));
    expectReduction();
}

TEST_F(StrangersPath, severalPoseLabels) {
    SimulatedRobot robot;
    const auto late = robot.localisation("EARLY");
    robot.wait(100);
    writeLog(in_, Observations{late, robot.localisation("IN TIME"), robot.cloud()});
    expectReduction();
}

TEST_F(StrangersPath, labelOfAnyBytes) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.localisation("it's\n\xff"), robot.localisation("$(other)"),
                               robot.cloud("-x `y`")});
    expectReduction();
}

TEST_F(StrangersPath, fileNameOfAnyBytes) {
    in_ = folder_ / "a b's.rawlog";
    writeLog(in_, smallLog());
    std::string line = facts().at("command_line");
    replace(line, "offmap", offmapBinary());
    replace(line, "MAP", map_.string());
    const RunResult run = runProgram({"/bin/bash", "-c", line}, {.folder = folder_.path()});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "a b's.reduced.rawlog"));
}

TEST_F(StrangersPath, truncatedLog) {
    SimulatedRobot robot;
    Observations log = smallLog();
    log.push_back(robot.vlp16());
    writeLog(in_, log, std::nullopt);
    const std::string bytes = readFile(in_);
    writeFile(in_, bytes.substr(0, bytes.size() - 1000));
    std::string line = facts({}, 2).at("command_line");
    EXPECT_THAT(line, testing::HasSubstr("--keep-going"));
    replace(line, "offmap", offmapBinary());
    replace(line, "MAP", map_.string());
    const RunResult run = runProgram({"/bin/bash", "-c", line}, {.folder = folder_.path()});
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
    EXPECT_EQ(entriesOf(folder_ / "in.reduced.rawlog").size(), 3U);
}

TEST_F(StrangersPath, adviceThatWasTakenIsNotGivenAgain) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.cloud()});
    EXPECT_THAT(missing(facts()), ElementsAre("--map MAP", "--pose X,Y,YAW_DEG"));
    EXPECT_THAT(missing(facts({"--pose", "2,2.5,17"})), ElementsAre("--map MAP"));
    const json complete = facts({"--pose", "2,2.5,17", "--map", map_});
    EXPECT_THAT(missing(complete), testing::IsEmpty());
    EXPECT_THAT(complete.at("placeholders"), testing::IsEmpty());
}

}  // namespace
