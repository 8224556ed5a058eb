// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"
#include "PoseChoiceFixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace offmap::rawlog {
namespace {

using core::PoseFault;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class PoseChoice : public PoseChoiceFixture {};

constexpr double rounding = 1e-12;

TEST_F(PoseChoice, robotPosesGoBeforeMovements) {
    addRobotPoses("AMCL");
    addActions();
    addOdometry("ODOMETRY");
    const ChosenPoses poses = choose({});
    EXPECT_EQ(poses.origin, PoseOrigin::RobotPoses);
    EXPECT_EQ(poses.description, "AMCL: 3 robot poses (not used: actions, ODOMETRY)");
    EXPECT_EQ(xAt(poses, 1), 11);
    EXPECT_EQ(poses.warning, "");
}

TEST_F(PoseChoice, actionsGoBeforeOdometry) {
    addActions();
    addOdometry("ODOMETRY");
    const ChosenPoses poses = choose(from({3, 4, 0}));
    EXPECT_EQ(poses.origin, PoseOrigin::Actions);
    EXPECT_EQ(poses.description,
              "actions: 2 movements from 3,4,0 (--initial-pose) (not used: ODOMETRY)");
    EXPECT_NEAR(xAt(poses, 2), 5, rounding);
}

TEST_F(PoseChoice, odometryBeginsAtTheInitialPose) {
    addOdometry("ODOMETRY");
    const ChosenPoses poses = choose(from({3, 4, M_PI}));
    EXPECT_EQ(poses.origin, PoseOrigin::Odometry);
    EXPECT_EQ(poses.description, "ODOMETRY: 3 odometry readings from 3,4,180 (--initial-pose)");
    EXPECT_NEAR(xAt(poses, 0), 3, rounding);
    EXPECT_NEAR(xAt(poses, 2), -1, rounding);
    const Eigen::Matrix3d begin = poses.source->at(second(0)).groundCovariance;
    EXPECT_NEAR(begin(0, 0), std::pow(config_.pose.sigmaPosition, 2), rounding);
    EXPECT_NEAR(begin(2, 2), std::pow(config_.pose.sigmaYaw, 2), rounding);
    const Eigen::Matrix3d end = poses.source->at(second(2)).groundCovariance;
    EXPECT_NEAR(end(2, 2), begin(2, 2) + 4 * std::pow(config_.odometry.headingPerMetre, 2),
                rounding);
}

TEST_F(PoseChoice, faultyOdometryIsToldFromThereOn) {
    addOdometry("ODOMETRY");
    survey_.odometry["ODOMETRY"][2].vehicleInOdometry.y = std::numeric_limits<double>::infinity();
    const ChosenPoses poses = choose(from({0, 0, 0}));
    EXPECT_TRUE(poses.source->at(second(0)).vehicleInMap);
    EXPECT_EQ(poses.source->at(second(1)).fault, PoseFault::NotFinite);
    EXPECT_FALSE(poses.source->at(second(2)).vehicleInMap);
    EXPECT_EQ(poses.source->at(second(2)).fault, PoseFault::NotFinite);
}

TEST_F(PoseChoice, labelChoosesAmongAll) {
    addRobotPoses("AMCL");
    addRobotPoses("GPS", 50);
    addActions();
    addOdometry("ODOMETRY");
    EXPECT_EQ(xAt(choose(labelled("GPS")), 0), 50);
    EXPECT_EQ(choose(labelled("actions", TPose2D())).origin, PoseOrigin::Actions);
    const ChosenPoses odometry = choose(labelled("ODOMETRY", TPose2D()));
    EXPECT_EQ(odometry.origin, PoseOrigin::Odometry);
    EXPECT_THAT(odometry.description, HasSubstr("(not used: AMCL, GPS, actions)"));
}

TEST_F(PoseChoice, unclearLabelsAreRefused) {
    addRobotPoses("AMCL");
    addRobotPoses("GPS");
    EXPECT_THAT(refusalOf({}),
                AllOf(HasSubstr("robot poses of several labels"), HasSubstr("AMCL, GPS")));
    EXPECT_THAT(refusalOf(labelled("SLAM")), AllOf(HasSubstr("'SLAM'"), HasSubstr("AMCL, GPS")));
    EXPECT_THAT(refusalOf(labelled("actions")), HasSubstr("'actions'"));
}

TEST_F(PoseChoice, severalOdometriesAreRefused) {
    addOdometry("LEFT");
    addOdometry("RIGHT");
    EXPECT_THAT(refusalOf(from({})),
                AllOf(HasSubstr("odometry of several labels"), HasSubstr("LEFT, RIGHT")));
    EXPECT_EQ(choose(labelled("RIGHT", TPose2D())).origin, PoseOrigin::Odometry);
}

TEST_F(PoseChoice, initialPoseBesideRobotPosesIsRefused) {
    addRobotPoses("AMCL");
    EXPECT_THAT(refusalOf(from({})),
                AllOf(HasSubstr("robot poses (AMCL)"), Not(HasSubstr("--pose-label"))));
    addActions();
    EXPECT_THAT(refusalOf(from({})), HasSubstr("--pose-label, of: actions"));
    EXPECT_THAT(refusalOf(labelled("AMCL", TPose2D())), HasSubstr("leave it out"));
}

TEST_F(PoseChoice, movementsWithoutABeginningAreNoPoses) {
    addActions();
    addOdometry("ODOMETRY");
    EXPECT_THAT(lackOf({}),
                AllOf(HasSubstr("actions: 2 movements"), HasSubstr("ODOMETRY: 3 odometry readings"),
                      HasSubstr("--initial-pose x,y,yaw_deg"), HasSubstr("--keep-going")));
    const ChosenPoses none = choose({}, true);
    EXPECT_EQ(none.origin, PoseOrigin::None);
    EXPECT_EQ(none.description, "none (not used: actions, ODOMETRY)");
    EXPECT_EQ(none.source->at(second(0)).fault, PoseFault::NoPose);
}

TEST_F(PoseChoice, logWithoutAnythingIsTold) {
    EXPECT_THAT(lackOf({}), AllOf(HasSubstr("run7.rawlog holds no robot pose"),
                                  HasSubstr("--pose "), HasSubstr("--trajectory")));
    EXPECT_THAT(lackOf(from({})), HasSubstr("no movement"));
    EXPECT_EQ(choose({}, true).description, "none");
}

// Nothing tells when the vehicle had moved so.
TEST_F(PoseChoice, actionsThatLeadToNoTimeAreNoPoses) {
    survey_.actions.movements = 1;
    survey_.actions.steps = {{{}, {1, 0, 0, 0, 0, 0}, {}, {}}};
    EXPECT_THAT(lackOf(from({})), HasSubstr("no movement"));
}

TEST_F(PoseChoice, fixedPoseHoldsAlways) {
    addRobotPoses("AMCL");
    PoseRequest request;
    request.fixed = TPose2D(2, 2.5, 0.3);
    const ChosenPoses poses = choose(request);
    EXPECT_EQ(poses.origin, PoseOrigin::Fixed);
    EXPECT_EQ(poses.description, "fixed at 2,2.5,17.1887 (not used: AMCL)");
    EXPECT_EQ(xAt(poses, 1e6), 2);
}

TEST_F(PoseChoice, trajectoryTakesTheirPlace) {
    const test::TemporaryFolder folder;
    test::writeFile(folder / "run7.tum", "1700000000 7 0 0 0 0 0 1\n1700000002 9 0 0 0 0 0 1\n");
    addRobotPoses("AMCL");
    addRobotPoses("GPS");
    PoseRequest request;
    request.trajectory = folder / "run7.tum";
    config_.pose.maxAge = 1;
    const ChosenPoses poses = choose(request);
    EXPECT_EQ(poses.origin, PoseOrigin::Trajectory);
    EXPECT_EQ(poses.description, "trajectory run7.tum: 2 poses (not used: AMCL, GPS)");
    EXPECT_NEAR(xAt(poses, 1), 8, rounding);
    EXPECT_EQ(poses.source->at(second(1)).groundCovariance(0, 0), 0.05 * 0.05);
}

TEST_F(PoseChoice, contradictoryRequestsAreRefused) {
    PoseRequest delayedFixed;
    delayedFixed.fixed = TPose2D();
    delayedFixed.delay = 1;
    EXPECT_THAT(refusalOf(delayedFixed), HasSubstr("--pose-delay"));
    PoseRequest labelledTrajectory = labelled("AMCL");
    labelledTrajectory.trajectory = "run7.tum";
    EXPECT_THAT(refusalOf(labelledTrajectory), HasSubstr("--pose-label"));
    for (const double delay : {std::numeric_limits<double>::quiet_NaN(), 1e11}) {
        PoseRequest endless;
        endless.delay = delay;
        EXPECT_THAT(refusalOf(endless), HasSubstr("--pose-delay"));
    }
}

}  // namespace
}  // namespace offmap::rawlog
