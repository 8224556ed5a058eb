// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/PositionEllipse.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

TPoint2D towards(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Covariance of an ellipse with half-axes a and b, a at an angle to x.
Eigen::Matrix2d covarianceOf(double a, double b, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    Eigen::Matrix2d rotation;
    rotation << c, -s, s, c;
    return rotation * Eigen::Vector2d(a * a, b * b).asDiagonal() * rotation.transpose();
}

/// Eq. 6 as printed.
double radiusAsPrinted(double a, double b, double kappa) {
    return b / std::sqrt(1 - a * a * b * b * std::cos(kappa) * std::cos(kappa));
}

// Variances of 0.01 m^2 are rounded by 1e-18, which is 1e-17 of a half-axis of 5 cm.
constexpr double rounding = 1e-15;

}  // namespace

TEST(PositionEllipse, radiusIsTheHalfAxisAlongEachAxis) {
    const PositionEllipse ellipse(covarianceOf(0.10, 0.05, 0));
    EXPECT_NEAR(ellipse.semiMajor(), 0.10, rounding);
    EXPECT_NEAR(ellipse.semiMinor(), 0.05, rounding);
    EXPECT_NEAR(ellipse.radius({1, 0}), 0.10, rounding);
    EXPECT_NEAR(ellipse.radius({-1, 0}), 0.10, rounding);
    EXPECT_NEAR(ellipse.radius({0, 1}), 0.05, rounding);
    EXPECT_NEAR(ellipse.radius({0, -1}), 0.05, rounding);
}

TEST(PositionEllipse, equationAsPrintedIsNotReproduced) {
    // The printed root holds m^4: 0.05 m in every direction.
    const PositionEllipse ellipse(covarianceOf(0.10, 0.05, 0));
    EXPECT_NEAR(radiusAsPrinted(0.10, 0.05, 0), 0.05, 1e-6);
    EXPECT_NEAR(ellipse.radius({1, 0}), 2 * radiusAsPrinted(0.10, 0.05, 0), 3e-6);
}

TEST(PositionEllipse, handSolvedAtThirtyDegrees) {
    // 1 / r^2 = cos^2 / a^2 + sin^2 / b^2 = 75 + 100
    const PositionEllipse ellipse(covarianceOf(0.10, 0.05, 0));
    EXPECT_NEAR(ellipse.radius(towards(std::numbers::pi / 6)), 1 / std::sqrt(175.0), rounding);
}

TEST(PositionEllipse, kappaCountsFromTheMajorAxis) {
    for (int degrees = -180; degrees <= 180; degrees += 15) {
        const double angle = degrees * std::numbers::pi / 180;
        const PositionEllipse ellipse(covarianceOf(0.10, 0.05, angle));
        EXPECT_NEAR(ellipse.radius(towards(angle)), 0.10, rounding);
        EXPECT_NEAR(ellipse.radius(towards(angle + std::numbers::pi / 2)), 0.05, rounding);
        EXPECT_NEAR(ellipse.radius(towards(angle - std::numbers::pi / 6)), 1 / std::sqrt(175.0),
                    rounding);
    }
}

TEST(PositionEllipse, boundaryHoldsTheShareThatAGaussianHasWithinOneSigma) {
    // P(chi^2 of two degrees <= 1) = 1 - exp(-1/2); five deviations of a share of N samples.
    constexpr int samples = 100'000;
    const double expected = 1 - std::exp(-0.5);
    const double tolerance = 5 * std::sqrt(expected * (1 - expected) / samples);
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    for (const double angle : {0.0, 0.4, 2.0}) {
        const PositionEllipse ellipse(covarianceOf(0.10, 0.03, angle));
        int within = 0;
        for (int i = 0; i < samples; ++i) {
            const double along = 0.10 * normal(random), across = 0.03 * normal(random);
            const TPoint2D at =
                towards(angle) * along + towards(angle + std::numbers::pi / 2) * across;
            const double distance = at.norm();
            within += distance <= ellipse.radius(at * (1 / distance));
        }
        EXPECT_NEAR(double(within) / samples, expected, tolerance);
    }
}

TEST(PositionEllipse, circleHasOneRadius) {
    const PositionEllipse ellipse(covarianceOf(0.07, 0.07, 0));
    for (int i = 0; i < 36; ++i) EXPECT_NEAR(ellipse.radius(towards(0.2 * i)), 0.07, rounding);
}

TEST(PositionEllipse, certainPositionHasNoRadius) {
    for (const PositionEllipse& ellipse :
         {PositionEllipse(), PositionEllipse(covarianceOf(0, 0, 0))}) {
        EXPECT_EQ(ellipse.semiMajor(), 0);
        for (int i = 0; i < 36; ++i) EXPECT_EQ(ellipse.radius(towards(0.2 * i)), 0);
    }
}

TEST(PositionEllipse, ellipseOfNoWidthReachesAlongItsAxisOnly) {
    const PositionEllipse ellipse(covarianceOf(0.10, 0, 0));
    EXPECT_EQ(ellipse.semiMinor(), 0);
    EXPECT_EQ(ellipse.radius({1, 0}), ellipse.semiMajor());
    EXPECT_EQ(ellipse.radius({0, 1}), 0);
    EXPECT_EQ(ellipse.radius(towards(0.01)), 0);
}

}  // namespace offmap::core
