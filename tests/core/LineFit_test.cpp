// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineFit.h>

#include <gtest/gtest.h>
#include <mrpt/math/TLine2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/geometry.h>

#include <numbers>
#include <random>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

FittedLine fitTo(const std::vector<TPoint2D>& points) {
    LineFit fit;
    for (const TPoint2D& p : points) fit.add(p);
    return fit.line();
}

/// 40 points within 5 m along a direction, 2 cm of noise across it.
std::vector<TPoint2D> noisyLine(double angle, std::mt19937& random) {
    std::uniform_real_distribution<double> along(-2.5, 2.5);
    std::normal_distribution<double> across(0, 0.02);
    const TPoint2D u(std::cos(angle), std::sin(angle)), n(-u.y, u.x);
    std::vector<TPoint2D> points;
    for (int i = 0; i < 40; ++i) {
        points.push_back(TPoint2D(1, 2) + u * along(random) + n * across(random));
    }
    return points;
}

double crossOf(const TPoint2D& a, const TPoint2D& b) { return a.x * b.y - a.y * b.x; }

// Sums over 40 points of a few metres: 1e3 roundings of 1e-15.
constexpr double rounding = 1e-12;

}  // namespace

TEST(LineFit, agreesWithMrptRegressionLine) {
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        const auto points = noisyLine(0.0631 * i, random);
        const FittedLine line = fitTo(points);
        mrpt::math::TLine2D oracle;
        mrpt::math::getRegressionLine(points, oracle);
        oracle.unitarize();
        EXPECT_NEAR(oracle.distance(line.at(-3)), 0, 10 * rounding);
        EXPECT_NEAR(oracle.distance(line.at(+3)), 0, 10 * rounding);
        EXPECT_NEAR(line.direction.norm(), 1, rounding);
    }
}

TEST(LineFit, movesWithItsPoints) {
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
        const auto points = noisyLine(0.0631 * i, random);
        const mrpt::math::TPose2D motion(3, -2, 0.1 * i);
        std::vector<TPoint2D> moved;
        for (const TPoint2D& p : points) moved.push_back(motion.composePoint(p));
        const FittedLine line = fitTo(moved), still = fitTo(points);
        EXPECT_NEAR(line.distance(motion.composePoint(still.at(-3))), 0, 10 * rounding);
        EXPECT_NEAR(line.distance(motion.composePoint(still.at(+3))), 0, 10 * rounding);
    }
}

TEST(LineFit, losesNothingFarFromTheOrigin) {
    std::mt19937 random(3);
    const TPoint2D far(1e6, -1e6);
    // Coordinates of 1e6 m are multiples of 1.2e-10 m, the line is some 4 m long.
    constexpr double spacing = 1.2e-10;
    for (int i = 0; i < 100; ++i) {
        const auto points = noisyLine(0.0631 * i, random);
        std::vector<TPoint2D> moved;
        for (const TPoint2D& p : points) moved.push_back(p + far);
        const FittedLine line = fitTo(moved), still = fitTo(points);
        EXPECT_NEAR(crossOf(line.direction, still.direction), 0, spacing);
        EXPECT_NEAR(line.distance(still.point + far), 0, 2 * spacing);
    }
}

TEST(LineFit, directionOfExactLinesIsExactInEveryDirection) {
    for (int degrees = 0; degrees < 360; ++degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const TPoint2D u(std::cos(angle), std::sin(angle));
        const FittedLine line = fitTo({u * 1, u * 2, u * 3, u * 5});
        EXPECT_NEAR(crossOf(line.direction, u), 0, 1e-15) << degrees << " degrees";
        EXPECT_NEAR(line.direction.norm(), 1, 1e-15);
    }
}

TEST(LineFit, verticalLineIsVertical) {
    const FittedLine line = fitTo({{2, 0}, {2, 1}, {2, 2.5}});
    EXPECT_EQ(line.direction.x, 0);
    EXPECT_EQ(std::abs(line.direction.y), 1);
    EXPECT_EQ(line.distance({2, 17}), 0);
    EXPECT_EQ(line.distance({2.25, -3}), 0.25);
}

TEST(LineFit, handSolvedSquaresAreLeast) {
    // Symmetric about y = 1, which leaves 4 x 0.1^2; any other line through (1.5, 1) leaves more.
    const FittedLine line = fitTo({{0, 0.9}, {1, 1.1}, {2, 1.1}, {3, 0.9}});
    EXPECT_NEAR(line.direction.y, 0, 1e-15);
    EXPECT_NEAR(line.point.y, 1, 1e-15);
    EXPECT_NEAR(line.along({3, 0.9}) - line.along({0, 0.9}), 3, 1e-15);
}

TEST(LineFit, coincidingPointsGiveALineAlongX) {
    const FittedLine line = fitTo({{0.1, 0.2}, {0.1, 0.2}, {0.1, 0.2}});
    EXPECT_EQ(line.point, TPoint2D(0.1, 0.2));
    EXPECT_EQ(line.direction, TPoint2D(1, 0));
    EXPECT_EQ(fitTo({{3, 4}}).direction, TPoint2D(1, 0));
}

TEST(LineSums, addedUpAreThoseOfAllPoints) {
    std::mt19937 random(8);
    const auto points = noisyLine(0.7, random);
    for (size_t cut = 0; cut <= points.size(); ++cut) {
        LineSums first, second;
        for (size_t i = 0; i < points.size(); ++i) {
            (i < cut ? first : second).add(points[i].x, points[i].y);
        }
        first += second;
        const FittedLine line = first.line().withUnitVector();
        const FittedLine expected = fitTo(points);
        EXPECT_NEAR(crossOf(line.direction, expected.direction), 0, rounding) << "cut at " << cut;
        EXPECT_NEAR((line.point - expected.point).norm(), 0, rounding) << "cut at " << cut;
    }
}

TEST(LineSums, takenAwayLeaveThoseOfTheOtherPoints) {
    std::mt19937 random(9);
    const auto points = noisyLine(0.7, random);
    LineSums all, first;
    for (const TPoint2D& p : points) all.add(p.x, p.y);
    for (uint32_t cut = 1; cut + 2 <= points.size(); ++cut) {
        first.add(points[cut - 1].x, points[cut - 1].y);
        LineSums left = all;
        left -= first;
        const FittedLine line = left.line().withUnitVector();
        const FittedLine expected = fitTo({points.begin() + cut, points.end()});
        // Two points that happen to be near each other tell the direction 100 times worse.
        EXPECT_NEAR(crossOf(line.direction, expected.direction), 0, 100 * rounding) << cut;
        EXPECT_NEAR((line.point - expected.point).norm(), 0, 100 * rounding) << cut;
    }
}

TEST(LineFit, countsItsPoints) {
    LineFit fit;
    EXPECT_EQ(fit.count(), 0u);
    fit.add({1, 1});
    fit.add({1, 1});
    EXPECT_EQ(fit.count(), 2u);
}

}  // namespace offmap::core
