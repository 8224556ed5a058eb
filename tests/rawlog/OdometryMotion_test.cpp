// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/DeadReckoning.h>
#include <offmap/rawlog/OdometryMotion.h>

#include <gtest/gtest.h>
#include <mrpt/poses/CPose2D.h>

#include <cmath>
#include <limits>

namespace offmap::rawlog {
namespace {

using mrpt::math::TPose2D;

constexpr double rounding = 1e-12;

OdometryConfig noise(double positionPerMetre, double headingPerMetre, double headingPerRadian) {
    OdometryConfig config;
    config.positionPerMetre = positionPerMetre;
    config.headingPerMetre = headingPerMetre;
    config.headingPerRadian = headingPerRadian;
    return config;
}

StampedOdometry reading(double seconds, const TPose2D& pose) {
    return {mrpt::Clock::fromDouble(1.7e9 + seconds), pose};
}

Eigen::Matrix3d covarianceOf(const TPose2D& increment, const OdometryConfig& config) {
    return matrixOf(motionBetween(reading(0, {}), reading(1, increment), config).groundCovariance);
}

/// The covariance at the end of a path in readings, the beginning being known.
Eigen::Matrix3d covarianceAlong(const std::vector<TPose2D>& path, const OdometryConfig& config) {
    DeadReckoning reckoning(path.front(), 0, 0);
    for (size_t i = 1; i < path.size(); ++i) {
        reckoning.move(motionBetween(reading(static_cast<double>(i) - 1, path[i - 1]),
                                     reading(static_cast<double>(i), path[i]), config));
    }
    return matrixOf(reckoning.poses().back().groundCovariance);
}

TEST(OdometryMotion, incrementIsTakenInTheFrameOfItsBeginning) {
    const MotionStep step =
        motionBetween(reading(0, {3, 4, M_PI / 2}), reading(1, {3, 5, -M_PI}), OdometryConfig());
    EXPECT_NEAR(step.vehicleInPrevious.x, 1, rounding);
    EXPECT_NEAR(step.vehicleInPrevious.y, 0, rounding);
    EXPECT_NEAR(step.vehicleInPrevious.yaw, M_PI / 2, rounding);
    EXPECT_EQ(step.time, mrpt::Clock::fromDouble(1.7e9 + 1));
}

// The heading is a random walk of variance q s, so the end is off across by its integral:
// q s^3 / 3, with a covariance of q s^2 / 2.
TEST(OdometryMotion, straightLineIsAsSolvedByHand) {
    const Eigen::Matrix3d covariance = covarianceOf({4, 0, 0}, noise(0.05, 0.01, 0.5));
    EXPECT_NEAR(covariance(0, 0), 0.05 * 0.05 * 4, rounding);
    EXPECT_NEAR(covariance(1, 1), 0.05 * 0.05 * 4 + 1e-4 * 64 / 3, rounding);
    EXPECT_NEAR(covariance(1, 2), 1e-4 * 16 / 2, rounding);
    EXPECT_NEAR(covariance(2, 2), 1e-4 * 4, rounding);
    EXPECT_NEAR(covariance(0, 1), 0, rounding);
    EXPECT_NEAR(covariance(0, 2), 0, rounding);
}

TEST(OdometryMotion, sigmaAfterOneMetreIsWhatWasStated) {
    EXPECT_NEAR(std::sqrt(covarianceOf({1, 0, 0}, noise(0.05, 0, 0))(0, 0)), 0.05, rounding);
    EXPECT_NEAR(std::sqrt(covarianceOf({1, 0, 0}, noise(0, 0.02, 0))(2, 2)), 0.02, rounding);
    EXPECT_NEAR(std::sqrt(covarianceOf({0, 0, 1}, noise(0, 0, 0.03))(2, 2)), 0.03, rounding);
}

TEST(OdometryMotion, turnOnTheSpotLeavesThePositionCertain) {
    const Eigen::Matrix3d covariance = covarianceOf({0, 0, -2}, noise(0.05, 0.01, 0.1));
    EXPECT_NEAR(covariance(2, 2), 0.1 * 0.1 * 2, rounding);
    EXPECT_NEAR((covariance.topRows<2>().cwiseAbs().maxCoeff()), 0, rounding);
}

TEST(OdometryMotion, standingRobotStaysAsCertain) {
    EXPECT_EQ(covarianceOf({0, 0, 0}, OdometryConfig()), Eigen::Matrix3d::Zero());
}

TEST(OdometryMotion, lengthIsThatOfTheArc) {
    // A half circle of radius 2 m: 2 pi m long, the chord 4 m.
    const TPose2D halfCircle(0, 4, M_PI);
    EXPECT_NEAR(covarianceOf(halfCircle, noise(0.05, 0, 0))(0, 0), 0.05 * 0.05 * 2 * M_PI,
                rounding);
    EXPECT_NEAR(covarianceOf(halfCircle, noise(0, 0.01, 0))(2, 2), 1e-4 * 2 * M_PI, rounding);
}

// From the end of a quarter circle of radius r, the place at the angle a is away by
// r (1 - sin a, cos a); its mean over the way is r (1 - 2 / pi, 2 / pi), and the mean of its
// squares r^2 (3 / 2 - 4 / pi, 1 / 2). The heading's effect is that, turned by 90 degrees.
TEST(OdometryMotion, quarterCircleIsAsSolvedByHand) {
    const double radius = 2, q = 1e-4 * radius * M_PI / 2;  // [rad^2] over the whole way
    const Eigen::Matrix3d covariance = covarianceOf({2, 2, M_PI / 2}, noise(0, 0.01, 0));
    // Three points of Gauss-Legendre for sin^2 over a quarter turn: the error is f^(6) / 2016000,
    // f^(6) <= 32 (pi / 2)^6, so below 3e-4 of q r^2.
    const double tolerance = 3e-4 * q * radius * radius;
    EXPECT_NEAR(covariance(0, 0), q * radius * radius * 0.5, tolerance);
    EXPECT_NEAR(covariance(1, 1), q * radius * radius * (1.5 - 4 / M_PI), tolerance);
    EXPECT_NEAR(covariance(0, 2), -q * radius * 2 / M_PI, tolerance);
    EXPECT_NEAR(covariance(1, 2), q * radius * (1 - 2 / M_PI), tolerance);
}

TEST(OdometryMotion, straightLineInTenReadingsIsAsUncertain) {
    const OdometryConfig config;
    std::vector<TPose2D> path;
    for (int i = 0; i <= 10; ++i) path.emplace_back(0.3 * i, 0.4 * i, 0.7);
    const Eigen::Matrix3d inTen = covarianceAlong(path, config);
    const Eigen::Matrix3d inOne = covarianceAlong({path.front(), path.back()}, config);
    EXPECT_LT((inTen - inOne).cwiseAbs().maxCoeff(), rounding);
    EXPECT_GT(inOne(0, 0), 1e-3);
}

TEST(OdometryMotion, arcInTenReadingsIsAsUncertain) {
    const OdometryConfig config;
    std::vector<TPose2D> path;
    for (int i = 0; i <= 10; ++i) {
        const double turned = 0.1 * i;
        path.emplace_back(3 * std::sin(turned), 3 * (1 - std::cos(turned)), turned);
    }
    const Eigen::Matrix3d inTen = covarianceAlong(path, config);
    const Eigen::Matrix3d inOne = covarianceAlong({path.front(), path.back()}, config);
    // As for the quarter circle, with 32 (1 rad)^6: below 2e-5 of q r^2 = 9 (3 q_m + q_r), 3.3e-2.
    EXPECT_LT((inTen - inOne).cwiseAbs().maxCoeff(), 7e-7);
    EXPECT_GT(inOne(0, 0), 1e-3);
}

TEST(OdometryMotion, backwardsIsAsUncertainAsForwards) {
    const OdometryConfig config;
    const Eigen::Matrix3d forwards = covarianceOf({2, 0, 0}, config);
    const Eigen::Matrix3d backwards = covarianceOf({-2, 0, 0}, config);
    EXPECT_NEAR(backwards(1, 1), forwards(1, 1), rounding);
    EXPECT_NEAR(backwards(1, 2), -forwards(1, 2), rounding);
}

TEST(OdometryMotion, readingThatIsNotFiniteIsFaulty) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const TPose2D& pose : {TPose2D(nan, 0, 0), TPose2D(0, 0, nan),
                                TPose2D(std::numeric_limits<double>::infinity(), 0, 0)}) {
        EXPECT_EQ(motionBetween(reading(0, {}), reading(1, pose), {}).fault,
                  core::PoseFault::NotFinite);
        EXPECT_EQ(motionBetween(reading(0, pose), reading(1, {}), {}).fault,
                  core::PoseFault::NotFinite);
    }
}

}  // namespace
}  // namespace offmap::rawlog
