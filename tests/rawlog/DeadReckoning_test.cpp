// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/DeadReckoning.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include <cmath>
#include <limits>

namespace offmap::rawlog {
namespace {

using core::PoseFault;
using mrpt::math::TPose3D;
using mrpt::poses::CPosePDFGaussian;

mrpt::Clock::time_point second(double seconds) { return mrpt::Clock::fromDouble(1.7e9 + seconds); }

MotionStep step(double seconds, const TPose3D& increment, double sigmaPosition = 0.01,
                double sigmaHeading = 0.003) {
    const double variance = sigmaPosition * sigmaPosition;
    return {second(seconds),
            increment,
            {variance, 0, 0, 4 * variance, 0, sigmaHeading * sigmaHeading},
            {}};
}

TEST(DeadReckoning, frameBeforeAnyMovementHasTheInitialPose) {
    DeadReckoning reckoning({1, 2, 0.5}, 0.1, 0.02);
    reckoning.move({second(0), {}, {}, {}});
    ASSERT_EQ(reckoning.poses().size(), 1U);
    const StampedPose& pose = reckoning.poses()[0];
    EXPECT_EQ(pose.time, second(0));
    EXPECT_NEAR(pose.vehicleInMap.yaw, 0.5, 1e-15);  // through a matrix and back
    EXPECT_EQ(pose.vehicleInMap.x, 1);
    EXPECT_DOUBLE_EQ(pose.groundCovariance[0], 0.01);
    EXPECT_DOUBLE_EQ(pose.groundCovariance[5], 0.0004);
}

// Heading north, one metre ahead: the step's own x is the map's y, and a heading error of dyaw
// moves the end by -dyaw along the map's x.
TEST(DeadReckoning, oneStepNorthIsAsSolvedByHand) {
    DeadReckoning reckoning({1, 2, M_PI / 2}, 0.1, 0.02);
    reckoning.move(step(1, {1, 0, 0, 0.25, 0, 0}));
    const StampedPose& pose = reckoning.poses().at(0);
    constexpr double rounding = 1e-15;
    EXPECT_NEAR(pose.vehicleInMap.x, 1, rounding);
    EXPECT_NEAR(pose.vehicleInMap.y, 3, rounding);
    EXPECT_NEAR(pose.vehicleInMap.yaw, M_PI / 2 + 0.25, rounding);
    const auto& [xx, xy, xYaw, yy, yYaw, yawYaw] = pose.groundCovariance;
    EXPECT_NEAR(xx, 0.1 * 0.1 + 0.02 * 0.02 + 4 * 0.01 * 0.01, rounding);
    EXPECT_NEAR(xy, 0, rounding);
    EXPECT_NEAR(xYaw, -0.02 * 0.02, rounding);
    EXPECT_NEAR(yy, 0.1 * 0.1 + 0.01 * 0.01, rounding);
    EXPECT_NEAR(yYaw, 0, rounding);
    EXPECT_NEAR(yawYaw, 0.02 * 0.02 + 0.003 * 0.003, rounding);
}

TEST(DeadReckoning, inThePlaneItIsTheCompositionOfMrpt) {
    DeadReckoning reckoning({1, -2, 3}, 0.05, 0.02);
    CPosePDFGaussian expected({1, -2, 3});
    expected.cov.setZero();
    expected.cov(0, 0) = expected.cov(1, 1) = 0.05 * 0.05;
    expected.cov(2, 2) = 0.02 * 0.02;
    for (int i = 0; i < 200; ++i) {
        const TPose3D increment(0.3 + 0.1 * std::sin(i), 0.05 * std::cos(i), 0,
                                0.2 * std::sin(0.1 * i), 0, 0);
        const MotionStep next = step(i, increment);
        reckoning.move(next);
        CPosePDFGaussian moved({increment.x, increment.y, increment.yaw});
        moved.cov = mrpt::math::CMatrixDouble33(matrixOf(next.groundCovariance));
        expected += moved;
    }
    const StampedPose& pose = reckoning.poses().back();
    // 200 steps, each rounded to 1e-16 of some 30 m; variances reach 10 m^2.
    constexpr double rounding = 1e-11;
    EXPECT_NEAR(pose.vehicleInMap.x, expected.mean.x(), rounding);
    EXPECT_NEAR(pose.vehicleInMap.y, expected.mean.y(), rounding);
    EXPECT_NEAR(std::remainder(pose.vehicleInMap.yaw - expected.mean.phi(), 2 * M_PI), 0, rounding);
    const Eigen::Matrix3d difference = matrixOf(pose.groundCovariance) - expected.cov.asEigen();
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), rounding);
}

TEST(DeadReckoning, inSpaceTheMeanIsTheCompositionOfMrpt) {
    DeadReckoning reckoning({1, -2, 3}, 0.05, 0.02);
    mrpt::poses::CPose3D expected(1, -2, 0, 3, 0, 0);
    for (int i = 0; i < 50; ++i) {
        const TPose3D increment(0.3, 0.02, 0.01, 0.1, 0.02 * std::sin(i), -0.01);
        reckoning.move(step(i, increment));
        expected = expected + mrpt::poses::CPose3D(increment);
    }
    const TPose3D reckoned = reckoning.poses().back().vehicleInMap;
    constexpr double rounding = 1e-12;
    for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(reckoned[i], expected.asTPose()[i], rounding) << i;
}

TEST(DeadReckoning, steepPitchDoesNotInflateTheYawVariance) {
    DeadReckoning reckoning({0, 0, 0}, 0.05, 0.02);
    reckoning.move(step(0, {0, 0, 0, 0, M_PI / 2 - 1e-4, 0}));
    reckoning.move(step(1, {0.1, 0, 0, 0, 0, 0}));
    EXPECT_NEAR(reckoning.poses().back().groundCovariance[5], 0.02 * 0.02 + 2 * 0.003 * 0.003,
                1e-15);
}

TEST(DeadReckoning, stepWithoutATimeMovesButLeavesNoPose) {
    DeadReckoning reckoning({0, 0, 0}, 0.05, 0.02);
    MotionStep untold = step(0, {1, 0, 0, 0, 0, 0});
    untold.time.reset();
    reckoning.move(untold);
    EXPECT_TRUE(reckoning.poses().empty());
    reckoning.move(step(1, {1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(reckoning.poses().at(0).vehicleInMap.x, 2);
}

TEST(DeadReckoning, afterAFaultyMovementNothingIsKnown) {
    for (const PoseFault fault : {PoseFault::NotFinite, PoseFault::NotPsd}) {
        DeadReckoning reckoning({0, 0, 0}, 0.05, 0.02);
        reckoning.move(step(0, {1, 0, 0, 0, 0, 0}));
        reckoning.move({second(1), {}, {}, fault});
        reckoning.move(step(2, {1, 0, 0, 0, 0, 0}));
        ASSERT_EQ(reckoning.poses().size(), 3U);
        EXPECT_FALSE(reckoning.poses()[0].fault);
        EXPECT_EQ(reckoning.poses()[1].fault, fault);
        EXPECT_EQ(reckoning.poses()[2].fault, fault);
    }
}

TEST(DeadReckoning, overflowIsFaulty) {
    constexpr double huge = std::numeric_limits<double>::max();
    DeadReckoning reckoning({0, 0, 0}, 0.05, 0.02);
    reckoning.move(step(0, {huge, 0, 0, 0, 0, 0}));
    reckoning.move(step(1, {huge, 0, 0, 0, 0, 0}));
    EXPECT_EQ(reckoning.poses().back().fault, PoseFault::NotFinite);
}

}  // namespace
}  // namespace offmap::rawlog
