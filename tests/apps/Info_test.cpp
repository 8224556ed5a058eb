// SPDX-License-Identifier: BSD-3-Clause
#include "InfoFixture.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservationPointCloud.h>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Info : public InfoFixture {};

TEST_F(Info, tellsSensorsPosesAndTheFile) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 3));
    const json facts = Info::facts();
    EXPECT_EQ(facts["log"]["file"], in_.string());
    EXPECT_EQ(facts["log"]["gzip"], true);
    EXPECT_EQ(facts["log"]["damage"], nullptr);
    EXPECT_EQ(facts["log"]["first_time_utc"], "2023-11-14T22:13:20.000Z");
    const json vlp16 = sensor(facts, "VLP16");
    EXPECT_EQ(vlp16["model"], "VLP-16");
    EXPECT_EQ(vlp16["scans"], 3);
    // One a second; the robot waits some 100 times in it, each to a tick of 100 ns.
    EXPECT_NEAR(vlp16["rate_hz"].get<double>(), 1, 2e-5);
    EXPECT_NEAR(vlp16["mounting"]["z_m"].get<double>(), 1.1, 1e-12);
    EXPECT_EQ(sensor(facts, "SWEEP")["scans"], 3);
    EXPECT_EQ(sensor(facts, "SWEEP")["mounting_varies"], true);
    EXPECT_EQ(sensor(facts, "FRONT_LASER")["scans_3d"], false);
    EXPECT_EQ(facts["poses"][0]["label"], "LOCALIZATION");
    EXPECT_EQ(facts["poses"][0]["chosen"], true);
    EXPECT_NEAR(facts["poses"][0]["sigma_m"].get<double>(), 0.02, 1e-9);
    EXPECT_NEAR(facts["poses"][0]["sigma_deg"].get<double>(), 0.5, 1e-9);
    const json& coverage = facts["poses"][0]["coverage"];
    EXPECT_EQ(coverage["observations"], 3 * (1 + 1 + 90));
    EXPECT_EQ(coverage["covered"], coverage["observations"]);
}

TEST_F(Info, textHoldsTheSameForAPerson) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 3));
    const RunResult run = info();
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, AllOf(HasSubstr("VLP-16, strongest return"), HasSubstr("LOCALIZATION"),
                               HasSubstr("cover 100.0 %"), HasSubstr("2023-11-14T22:13:20.000Z"),
                               HasSubstr("--map MAP"), HasSubstr("\noffmap reduce ")));
}

TEST_F(Info, tellsTheMovement) {
    SimulatedRobot robot;
    Observations log;
    for (int i = 0; i <= 40; ++i) {  // 1 m/s for 4 s, and 10 degrees/s
        robot.pose = mrpt::poses::CPose3D(2 + 0.1 * i, 2, 0, mrpt::DEG2RAD(1.0 * i), 0, 0);
        log.push_back(robot.localisation());
        if (i % 10 == 5) log.push_back(robot.cloud());
        robot.wait(0.1);
    }
    writeLog(in_, log);
    const json movement = facts()["movement"];
    // Steps count when they are longer than 0.1 m and 3 sigma = 0.06 m: at most one is open.
    EXPECT_NEAR(movement["distance_m"].get<double>(), 4, 0.2);
    // The vehicle is looked for every 0.1 s: the last look may be that much before the end.
    EXPECT_NEAR(movement["duration_s"].get<double>(), 4, 0.11);
    // Over half a second or more, of stamps to 2e-7 s.
    EXPECT_NEAR(movement["max_speed_m_per_s"].get<double>(), 1, 1e-5);
    EXPECT_NEAR(movement["max_turn_rate_deg_per_s"].get<double>(), 10, 1e-4);
}

TEST_F(Info, actionsAskWhereTheyBegan) {
    SimulatedRobot robot;
    writeLog(in_, drivenFrames(robot, 5));
    const json facts = Info::facts();
    EXPECT_EQ(facts["log"]["action_collections"], 5);
    EXPECT_EQ(facts["log"]["sensory_frames"], 5);
    EXPECT_EQ(facts["actions"]["CActionRobotMovement2D"], 5);
    EXPECT_THAT(missing(facts), ElementsAre("--map MAP", "--initial-pose X,Y,YAW_DEG"));
    EXPECT_THAT(missing(Info::facts({"--initial-pose", "2,2.5,17"})), ElementsAre("--map MAP"));
}

TEST_F(Info, odometryAsksWhereItBegan) {
    SimulatedRobot robot;
    writeLog(in_, drivenOdometry(robot, 5));
    const json facts = Info::facts();
    EXPECT_THAT(missing(facts), ElementsAre("--map MAP", "--initial-pose X,Y,YAW_DEG"));
    EXPECT_EQ(facts["poses"][0]["origin"], "odometry");
    // Two steps of 0.05 m make one of 0.1 m; the last ones may be open.
    EXPECT_NEAR(facts["movement"]["distance_m"].get<double>(), 0.2, 0.11);
}

TEST_F(Info, choosesThePosesThatCoverMost) {
    SimulatedRobot robot;
    Observations log{robot.localisation("A_ONCE")};
    robot.wait(100);
    for (int i = 0; i < 4; ++i) {
        log.insert(log.end(), {robot.localisation("B_ALWAYS"), robot.cloud()});
        robot.wait(1);
    }
    writeLog(in_, log);
    const json facts = Info::facts();
    EXPECT_THAT(missing(facts), ElementsAre("--map MAP", "--pose-label B_ALWAYS"));
    EXPECT_EQ(facts["poses"][0]["coverage"]["not_covered"]["pose_too_old"], 4);
    EXPECT_EQ(facts["poses"][1]["coverage"]["covered"], 4);
    EXPECT_THAT(missing(Info::facts({"--pose-label", "B_ALWAYS"})), ElementsAre("--map MAP"));
}

TEST_F(Info, anotherClockIsToldWithTheDelay) {
    SimulatedRobot robot;
    Observations log{robot.localisation()};
    robot.wait(3600);
    log.push_back(robot.cloud());
    writeLog(in_, log);
    const json step = facts()["missing"].back();
    EXPECT_THAT(step["what"].get<std::string>(),
                AllOf(HasSubstr("end 3600.0 s before"), HasSubstr("(-3600.0 s")));
    EXPECT_EQ(step["option"], "--pose-delay SECONDS");
    EXPECT_THAT(missing(facts({"--pose-delay", "-3600"})), ElementsAre("--map MAP"));
}

TEST_F(Info, posesThatAreTooOldOrUncertainAreAdvice) {
    SimulatedRobot robot;
    Observations log{robot.localisation(), robot.cloud()};
    robot.wait(10);
    log.push_back(robot.cloud());
    robot.wait(10);
    robot.pose = mrpt::poses::CPose3D(2, 4.5, 0, 0.3, 0, 0);  // it did not stand in between
    const auto vague = robot.localisation();
    vague->pose.cov(0, 0) = 4;
    log.insert(log.end(), {vague, robot.cloud()});
    writeLog(in_, log);
    const json facts = Info::facts();
    const std::string advice = facts["advice"].dump();
    EXPECT_THAT(advice,
                AllOf(HasSubstr("pose.max_age_s"), HasSubstr("matching.max_position_radius_m")));
    EXPECT_EQ(facts["poses"][0]["coverage"]["covered"], 1);
}

TEST_F(Info, logWithoutScansSaysSo) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.horizontalScan(), robot.imu()});
    const json facts = Info::facts();
    EXPECT_EQ(facts["has_scans_to_reduce"], false);
    EXPECT_THAT(facts["command"], testing::IsEmpty());
    EXPECT_EQ(facts["command_line"], nullptr);
    EXPECT_THAT(info().out, AllOf(HasSubstr("2D scanner, level"), HasSubstr("nothing to reduce"),
                                  HasSubstr("point clouds"), Not(HasSubstr("offmap reduce "))));
}

TEST_F(Info, onlyTheChosenSensorCounts) {
    SimulatedRobot robot;
    writeLog(in_, secondsOf(robot, 1));
    const json facts = Info::facts({"--sensor", "VLP16"});
    EXPECT_EQ(facts["poses"][0]["coverage"]["observations"], 1);
    EXPECT_THAT(facts["command_line"].get<std::string>(), HasSubstr("--sensor VLP16"));
    EXPECT_THAT(facts["command_line"].get<std::string>(), HasSubstr("--config vlp16"));
    expectRefusal({"info", in_, "--sensor", "VLP61"}, 1, HasSubstr("VLP16"));
}

TEST_F(Info, settingsThatWereGivenStandInTheCommand) {
    writeLog(in_, smallLog());
    EXPECT_THAT(facts({"--set", "pose.max_age_s=2", "--map", map_, "--quiet"})["command"],
                ElementsAre("offmap", "reduce", in_.string(), "--map", map_.string(), "--set",
                            "pose.max_age_s=2", "-o", "in.reduced.rawlog"));
}

TEST_F(Info, externalFileThatIsGoneIsMissing) {
    SimulatedRobot robot;
    const auto cloud = robot.cloud();
    cloud->setAsExternalStorage(
        "gone.bin", mrpt::obs::CObservationPointCloud::ExternalStorageFormat::MRPT_Serialization);
    writeLog(in_, Observations{robot.localisation(), cloud});
    const json facts = Info::facts();
    EXPECT_EQ(sensor(facts, "CLOUD")["external_files_unreadable"], 1);
    EXPECT_THAT(facts["missing"][0]["what"].get<std::string>(), HasSubstr("gone.bin"));
}

TEST_F(Info, isValidJsonWhateverTheLabels) {
    SimulatedRobot robot;
    writeLog(in_, Observations{robot.localisation("\x80\"\n"), robot.cloud("\xc3\x28\x1b[31m")});
    EXPECT_EQ(facts()["sensors"].size(), 2U);
    EXPECT_THAT(info().out, Not(HasSubstr("\x1b")));
}

}  // namespace
