// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/maps/TextMap.h>
#include <offmap/maps/WallPlacement.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace offmap::maps {
namespace {

using mrpt::math::TPoint2D;
using testing::AllOf;
using testing::HasSubstr;

constexpr double rounding = 1e-13;  // some tens of roundings of coordinates of up to 30 m

std::vector<core::Wall> parsed(std::string_view text) {
    return parseTextMap(text, "plan.lines", 0.03);
}

std::string errorOf(std::string_view text) {
    try {
        parsed(text);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

double lengthOf(const std::vector<core::Wall>& walls) {
    double length = 0;
    for (const core::Wall& wall : walls) length += core::lengthOf(wall);
    return length;
}

void expectAt(const TPoint2D& place, double x, double y) {
    EXPECT_NEAR(place.x, x, rounding);
    EXPECT_NEAR(place.y, y, rounding);
}

TEST(TextMapArc, goesCounterClockwiseFromStartToEnd) {
    const auto walls = parsed("arc 1 2 3 90 180\n");
    ASSERT_EQ(walls.size(), 1U);
    expectAt(walls[0].line.point1, 1, 5);
    expectAt(walls[0].line.point2, -2, 2);
    EXPECT_EQ(walls[0].curvature, 1.0 / 3);
    EXPECT_EQ(walls[0].sigma, 0.03);
    EXPECT_EQ(walls[0].height, core::Interval::everything());
}

TEST(TextMapArc, goesAcrossZero) {
    for (const char* const text : {"arc 0 0 2 315 45", "arc 0 0 2 -45 45", "arc 0 0 2 675 765"}) {
        const auto walls = parsed(text);
        ASSERT_EQ(walls.size(), 1U) << text;
        expectAt(core::placeAt(walls[0], 0.5), 2, 0);
    }
}

TEST(TextMapArc, fullCircleIsFourWalls) {
    const auto walls = parsed("0 0 1 0\n  arc -7 3 0.4 0 360 # a column\n");
    ASSERT_EQ(walls.size(), 5U);
    EXPECT_EQ(walls[0].curvature, 0);
    EXPECT_EQ(walls[4].line.point2, walls[1].line.point1);
    EXPECT_NEAR(lengthOf({walls.begin() + 1, walls.end()}), 2 * M_PI * 0.4, rounding);
}

TEST(TextMapArc, sigmaAndHeightGoForEveryPiece) {
    for (const core::Wall& wall : parsed("arc 0 0 2 10 200 0.1 -0.5 2.5")) {
        EXPECT_EQ(wall.sigma, 0.1);
        EXPECT_EQ(wall.height, core::Interval(-0.5, 2.5));
    }
    EXPECT_EQ(parsed("arc 0 0 2 0 90 0.2")[0].sigma, 0.2);
}

TEST(TextMapArc, wrongFieldsAreNamed) {
    EXPECT_EQ(errorOf("0 0 1 0\narc 0 0 2 0 9O"),
              "plan.lines:2: end_deg is '9O', not a number; "
              "a wall is: x1 y1 x2 y2 [sigma [z_min z_max]], or: "
              "arc cx cy r start_deg end_deg [sigma [z_min z_max]], in metres");
    EXPECT_THAT(errorOf("arc"), HasSubstr("0 fields of an arc, but it takes 5, 6 or 8"));
    EXPECT_THAT(errorOf("arc 0 0 2 0"), HasSubstr("4 fields of an arc"));
    EXPECT_THAT(errorOf("arc 0 0 2 0 90 0.1 0"), HasSubstr("7 fields of an arc"));
    EXPECT_THAT(errorOf("arc 0 0 2 0 90 0.1 0 2 7"),
                HasSubstr("more than 8 fields, the 9th is '7'"));
    EXPECT_THAT(errorOf("arc 0 0 r"), HasSubstr("r is 'r', not a number"));
    EXPECT_THAT(errorOf("Arc 0 0 1 0 90"), HasSubstr("x1 is 'Arc', not a number"));
    EXPECT_THAT(errorOf("arc arc 0 0 2 0 90"), HasSubstr("cx is 'arc', not a number"));
}

TEST(TextMapArc, impossibleArcsAreErrors) {
    EXPECT_THAT(errorOf("0 0 1 0\narc 0 0 0 0 90"),
                HasSubstr("plan.lines:2: the radius is not above zero"));
    EXPECT_THAT(errorOf("arc 0 0 -2 0 90"), HasSubstr("the radius is not above zero"));
    EXPECT_THAT(errorOf("arc 0 0 2 90 90"),
                HasSubstr("start_deg is end_deg; a full circle goes from 0 to 360"));
    EXPECT_THAT(errorOf("arc 0 0 2 0 361"), HasSubstr("more than a full circle"));
    EXPECT_THAT(errorOf("arc 0 0 2 0 -360"), HasSubstr("a full circle or more apart"));
    EXPECT_THAT(errorOf("arc 0 0 2 0 nan"), HasSubstr("end_deg is 'nan', not finite"));
    EXPECT_THAT(errorOf("arc 0 0 1e308 0 90 0.1\n"), HasSubstr("plan.lines:1: an arc"));
    EXPECT_THAT(errorOf("arc 1e300 0 1 0 90"), HasSubstr("too small for numbers as large"));
    EXPECT_THAT(errorOf("arc 0 0 2 0 90 -0.1"), HasSubstr("sigma is -0.1, below zero"));
    EXPECT_THAT(errorOf("arc 0 0 2 0 90 0.1 2 1"), HasSubstr("z_min 2 is above z_max 1"));
}

// A quarter turn takes the arc's middle, 2 m ahead of its centre, to 2 m left of it.
TEST(TextMapArc, placingTurnsTheBulgeToo) {
    const auto walls =
        placed(parsed("arc 1 0 2 -45 45"), mrpt::poses::CPose2D(10, 20, mrpt::DEG2RAD(90.0)));
    ASSERT_EQ(walls.size(), 1U);
    expectAt(core::placeAt(walls[0], 0.5), 10, 23);
    expectAt(core::placeAt(walls[0], 0), 10 + std::sqrt(2.0), 21 + std::sqrt(2.0));
}

}  // namespace
}  // namespace offmap::maps
