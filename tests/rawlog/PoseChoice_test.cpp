// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/PoseChoice.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace offmap::rawlog {
namespace {

using core::PoseFault;
using mrpt::math::TPose2D;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

mrpt::Clock::time_point second(double seconds) { return mrpt::Clock::fromDouble(1.7e9 + seconds); }

class PoseChoice : public testing::Test {
 protected:
    PoseChoice() {
        SensorSurvey& lidar = survey_.sensors["LIDAR"];
        lidar.scans3d = true;
        lidar.times = TimeSpan{second(0), second(2)};
    }

    void addRobotPoses(const std::string& label, double x = 10) {
        for (int i = 0; i < 3; ++i) {
            survey_.poses[label].push_back({second(i), {x + i, 0, 0, 0, 0, 0}, {}, {}});
        }
    }

    /// A metre a second.
    void addActions() {
        survey_.actions.movements = 2;
        survey_.actions.steps = {{second(0), {}, {}, {}},
                                 {second(1), {1, 0, 0, 0, 0, 0}, {}, {}},
                                 {second(2), {1, 0, 0, 0, 0, 0}, {}, {}}};
    }

    /// Two metres a second; readings begin anywhere, and are not sorted.
    void addOdometry(const std::string& label) {
        survey_.odometry[label] = {
            {second(2), {9, 5, 0}}, {second(0), {5, 5, 0}}, {second(1), {7, 5, 0}}};
    }

    ChosenPoses choose(const PoseRequest& request, bool mayBeMissing = false) const {
        return choosePoses(request, config_, survey_, "run7.rawlog", mayBeMissing);
    }

    /// Why the request is wrong.
    std::string refusalOf(const PoseRequest& request) const {
        try {
            choose(request);
        } catch (const PoseRequestError& e) {
            return e.what();
        } catch (const std::runtime_error& e) {
            return std::string("no pose: ") + e.what();
        }
        return "no error";
    }

    /// Why there is no pose, the request being right.
    std::string lackOf(const PoseRequest& request) const {
        const std::string error = refusalOf(request), prefix = "no pose: ";
        return error.starts_with(prefix) ? error.substr(prefix.size()) : "another error";
    }

    static PoseRequest labelled(const std::string& label,
                                std::optional<TPose2D> initial = std::nullopt) {
        PoseRequest request;
        request.label = label;
        request.initial = initial;
        return request;
    }

    static PoseRequest from(const TPose2D& initial) { return labelled("", initial); }

    static double xAt(const ChosenPoses& poses, double seconds) {
        const PoseLookup lookup = poses.source->at(second(seconds));
        return lookup.vehicleInMap ? lookup.vehicleInMap->x()
                                   : std::numeric_limits<double>::quiet_NaN();
    }

    LogSurvey survey_;
    Config config_;
};

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

TEST_F(PoseChoice, lateStampsAreSetRight) {
    addRobotPoses("AMCL");  // a metre a second: the stamp 1.5 s tells where it was at 1.25 s
    PoseRequest request;
    request.delay = 0.25;
    const ChosenPoses late = choose(request);
    EXPECT_NEAR(xAt(late, 1.25), 11.5, 1e-6);  // ticks of 100 ns
    EXPECT_EQ(late.description, "AMCL: 3 robot poses, 0.25 s late");
    request.delay = -0.25;
    EXPECT_NEAR(xAt(choose(request), 1.25), 11, 1e-6);
}

TEST_F(PoseChoice, delayWorksForMovementsToo) {
    addOdometry("ODOMETRY");
    PoseRequest request = from({});
    request.delay = 0.5;
    EXPECT_NEAR(xAt(choose(request), 1), 3, 1e-6);
}

TEST_F(PoseChoice, delayAtTheEndsOfTimeIsHarmless) {
    survey_.poses["AMCL"] = {{mrpt::Clock::time_point::min(), {}, {}, {}},
                             {mrpt::Clock::time_point::max(), {}, {}, {}}};
    for (const double delay : {1e10, -1e10}) {
        PoseRequest request;
        request.delay = delay;
        EXPECT_EQ(choose(request).origin, PoseOrigin::RobotPoses);
    }
}

TEST_F(PoseChoice, posesOfAnotherClockAreWarnedOf) {
    addRobotPoses("AMCL");
    PoseRequest request;
    request.delay = 3600;
    EXPECT_THAT(choose(request).warning,
                AllOf(HasSubstr("1699996400.000 to 1699996402.000"),
                      HasSubstr("1700000000.000 to 1700000002.000"), HasSubstr("--pose-delay")));
    request.delay = 2 + config_.pose.maxAge;  // the last pose is just not too old for the first
    EXPECT_EQ(choose(request).warning, "");
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
