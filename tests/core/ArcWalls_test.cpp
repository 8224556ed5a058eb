// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>
#include <offmap/core/WallGeometry.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace offmap::core {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-14;  // some roundings of coordinates of up to 8 m

std::string errorOf(const CircularArc& arc) {
    try {
        wallsAlong(arc, {});
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "no error";
}

}  // namespace

TEST(ArcWalls, aQuarterIsOneWall) {
    const auto walls = wallsAlong({{2, 1}, 3, 0, pi / 2}, {{}, 0.07, {0, 2}});
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_EQ(walls[0].line.point1, (mrpt::math::TPoint2D{5, 1}));
    EXPECT_NEAR(walls[0].line.point2.x, 2, rounding);
    EXPECT_NEAR(walls[0].line.point2.y, 4, rounding);
    EXPECT_EQ(walls[0].curvature, 1.0 / 3);
    EXPECT_EQ(walls[0].sigma, 0.07);
    EXPECT_EQ(walls[0].height, Interval(0, 2));
    EXPECT_NEAR(lengthOf(walls[0]), 1.5 * pi, rounding);
}

TEST(ArcWalls, noPieceIsMoreThanAQuarter) {
    EXPECT_EQ(wallsAlong({{0, 0}, 1, 0.3, mrpt::DEG2RAD(91.0)}, {}).size(), 2U);
    EXPECT_EQ(wallsAlong({{0, 0}, 1, 0.3, pi}, {}).size(), 2U);
    EXPECT_EQ(wallsAlong({{0, 0}, 1, 0.3, mrpt::DEG2RAD(270.0)}, {}).size(), 3U);
}

TEST(ArcWalls, aFullCircleClosesExactly) {
    const auto walls = wallsAlong({{0.1, 0.2}, 0.7, mrpt::DEG2RAD(17.0), 2 * pi}, {});
    ASSERT_EQ(walls.size(), 4U);
    double length = 0;
    for (size_t i = 0; i < walls.size(); ++i) {
        EXPECT_EQ(walls[i].line.point2, walls[(i + 1) % walls.size()].line.point1);
        length += lengthOf(walls[i]);
    }
    EXPECT_NEAR(length, 2 * pi * 0.7, rounding);
}

TEST(ArcWalls, whatIsNoArcIsRefused) {
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(errorOf({{0, 0}, 0, 0, 1}), "the radius is not above zero");
    EXPECT_EQ(errorOf({{0, 0}, -1, 0, 1}), "the radius is not above zero");
    EXPECT_EQ(errorOf({{0, 0}, 1, 0, 0}), "an arc without length");
    EXPECT_EQ(errorOf({{0, 0}, 1, 0, 6.3}), "an arc of more than a full circle");
    EXPECT_EQ(errorOf({{0, infinite}, 1, 0, 1}), "an arc of a size that is not finite");
    EXPECT_EQ(errorOf({{0, 0}, 1e-320, 0, 1}), "an arc of a size that is not finite");
    // Next to 1e17 the nearest number is 16 away.
    EXPECT_EQ(errorOf({{1e17, 0}, 1, 0, 1}),
              "an arc too small for numbers as large as its centre's");
    EXPECT_EQ(errorOf({{1e6, -1e6}, 5, 0, 1}), "no error");
}

}  // namespace offmap::core
