// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/WallGeometry.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-13;  // some tens of roundings of lengths of up to 20 m

/// A quarter circle of radius 2 about the origin, from (2, 0) to (0, 2).
Wall quarter() { return wallsAlong({{0, 0}, 2, 0, pi / 2}, {}).front(); }

/// The same wall walked the other way: it bends to the right.
Wall backwards(Wall wall) {
    std::swap(wall.line.point1, wall.line.point2);
    wall.curvature = -wall.curvature;
    return wall;
}

void expectAt(const TPoint2D& place, double x, double y) {
    EXPECT_NEAR(place.x, x, rounding);
    EXPECT_NEAR(place.y, y, rounding);
}

}  // namespace

TEST(WallGeometry, raysMeetAnArcFromInsideAndOutside) {
    const double diagonal = std::sqrt(0.5);
    for (const Wall& wall : {quarter(), backwards(quarter())}) {
        EXPECT_NEAR(*rangeTo(wall, {0, 0}, {diagonal, diagonal}), 2, rounding);
        EXPECT_NEAR(*rangeTo(wall, {5, 1}, {-1, 0}), 5 - std::sqrt(3.0), rounding);
        EXPECT_NEAR(*rangeTo(wall, {0.5, 1}, {1, 0}), std::sqrt(3.0) - 0.5, rounding);
        EXPECT_FALSE(rangeTo(wall, {0, 0}, {-diagonal, diagonal})) << "past the end";
        EXPECT_FALSE(rangeTo(wall, {0, 0}, {-1, 0})) << "the other side of the circle";
        EXPECT_FALSE(rangeTo(wall, {3, 3}, {diagonal, diagonal})) << "behind the ray";
    }
}

// The line x + y = 2.5 lies between the chord, x + y = 2, and the tangent, x + y = 2.83.
TEST(WallGeometry, aRayAcrossTheBulgeMeetsItsNearSide) {
    const double diagonal = std::sqrt(0.5), halfChord = std::sqrt(4 - 2.5 * 2.5 / 2);
    for (const Wall& wall : {quarter(), backwards(quarter())}) {
        const TPoint2D outside(3.25, -0.75), inside(1.25, 1.25);
        EXPECT_NEAR(*rangeTo(wall, outside, {-diagonal, diagonal}),
                    (outside - inside).norm() - halfChord, rounding);
        EXPECT_NEAR(*rangeTo(wall, inside, {-diagonal, diagonal}), halfChord, rounding);
        EXPECT_NEAR(*rangeTo(wall, inside, {diagonal, -diagonal}), halfChord, rounding);
        EXPECT_FALSE(rangeTo(wall, {3.5, -0.6}, {-diagonal, diagonal})) << "past the tangent";
    }
}

// Along the chord, the ray meets the arc in both of its ends.
TEST(WallGeometry, aRayThroughAnEndMeetsIt) {
    const double diagonal = std::sqrt(0.5);
    Wall wall{{{2, 0}, {0, 2}}, 0.03, Interval::everything(), 0.5};
    EXPECT_NEAR(*rangeTo(wall, {3, -1}, {-diagonal, diagonal}), std::sqrt(2.0), rounding);
    EXPECT_NEAR(*rangeTo(wall, {2, -3}, {0, 1}), 3, 1e-7) << "tangent: the root of a rounding";
    EXPECT_NEAR(*rangeTo(wall, {-1, 2}, {1, 0}), 1, 1e-7);
}

TEST(WallGeometry, distanceIsToTheArcOrItsEnds) {
    for (const Wall& wall : {quarter(), backwards(quarter())}) {
        EXPECT_NEAR(distanceTo(wall, {3, 3}), std::sqrt(18.0) - 2, rounding);
        EXPECT_NEAR(distanceTo(wall, {0.6, 0.8}), 1, rounding);
        EXPECT_NEAR(distanceTo(wall, {0, 0}), 2, rounding);
        EXPECT_NEAR(distanceTo(wall, {2, -1.5}), 1.5, rounding);
        EXPECT_NEAR(distanceTo(wall, {-1, -1}), std::sqrt(10.0), rounding);
    }
}

TEST(WallGeometry, normalPointsTheBeamsWay) {
    const Wall wall = quarter();
    const TPoint2D place(3, 4), beam(1, 0.1);
    expectAt(normalAwayFrom(beam, wall, place), 0.6, 0.8);
    expectAt(normalAwayFrom(beam * -1.0, wall, place), -0.6, -0.8);
    EXPECT_NEAR(distanceBehind(place, wall, {0.6, 0.8}), 3, rounding);
    EXPECT_NEAR(distanceBehind(place, wall, {-0.6, -0.8}), -3, rounding);
    EXPECT_NEAR(distanceBehind({0.6, 0.8}, wall, {0.6, 0.8}), -1, rounding);
    EXPECT_NEAR(distanceBehind({-1.2, -1.6}, wall, {-0.6, -0.8}), 0, rounding) << "past the ends";
}

TEST(WallGeometry, shareGoesByTheArcsAngle) {
    const Wall wall = quarter(), back = backwards(wall);
    for (const double degrees : {0.0, 9.0, 30.0, 45.0, 81.0, 90.0}) {
        const double angle = mrpt::DEG2RAD(degrees), share = degrees / 90;
        const TPoint2D direction(std::cos(angle), std::sin(angle));
        EXPECT_NEAR(shareAlong(wall, direction * 3.0), share, rounding);
        EXPECT_NEAR(shareAlong(back, direction * 0.5), 1 - share, rounding);
        expectAt(placeAt(wall, share), 2 * direction.x, 2 * direction.y);
        expectAt(placeAt(back, 1 - share), 2 * direction.x, 2 * direction.y);
    }
    EXPECT_EQ(shareAlong(wall, {2, -1}), 0);
    EXPECT_EQ(shareAlong(wall, {-0.1, 2}), 1);
}

TEST(WallGeometry, incidenceIsToTheTangent) {
    const Wall wall = quarter();
    const double diagonal = std::sqrt(0.5);
    EXPECT_NEAR(incidenceOn(wall, {diagonal, diagonal}, {1.2, 1.6}).angle(),
                pi / 2 - (std::atan2(1.6, 1.2) - pi / 4), rounding);
    EXPECT_NEAR(incidenceOn(wall, {0, 1}, {2 * diagonal, 2 * diagonal}).angle(), pi / 4, rounding);
}

TEST(WallGeometry, boundsHoldTheBulge) {
    const auto [low, high] = boundsOf(quarter());
    expectAt(low, 0, 0);
    expectAt(high, 2, 2);
    // About the x axis: ends at x = 2 cos 45 deg, the middle at 2.
    const Wall ahead = wallsAlong({{0, 0}, 2, -pi / 4, pi / 2}, {}).front();
    for (const Wall& wall : {ahead, backwards(ahead)}) {
        expectAt(boundsOf(wall).low, std::sqrt(2.0), -std::sqrt(2.0));
        expectAt(boundsOf(wall).high, 2, std::sqrt(2.0));
    }
}

// Bent so little that it strays from its chord by 5e-13 m, it must answer like a straight wall.
TEST(WallGeometry, allButStraightIsAsStraight) {
    const Wall straight{{{1, -1}, {3, 1}}};
    Wall bent = straight;
    bent.curvature = 1e-12;
    const TPoint2D origin(-2, 0.3), direction(std::cos(0.05), std::sin(-0.05)), place(1.5, 0.5);
    const TPoint2D beam(1, 0);
    const TPoint2D normal = normalAwayFrom(beam, straight, place);
    constexpr double stray = 2e-12;
    EXPECT_NEAR(*rangeTo(bent, origin, direction), *rangeTo(straight, origin, direction), stray);
    EXPECT_NEAR(distanceTo(bent, place), distanceTo(straight, place), stray);
    EXPECT_NEAR(distanceBehind(place, bent, normal), distanceBehind(place, straight, normal),
                stray);
    EXPECT_NEAR(shareAlong(bent, place), shareAlong(straight, place), stray);
    EXPECT_NEAR((placeAt(bent, 0.3) - placeAt(straight, 0.3)).norm(), 0, stray);
    EXPECT_NEAR(lengthOf(bent), lengthOf(straight), stray);
}

TEST(LineMap, refusesAWallBentTooFar) {
    EXPECT_NO_THROW(LineMap({{{{0, 0}, {2, 0}}, 0.03, Interval::everything(), -1}}));
    for (const double curvature : {1.01, -1.01, std::nan("")}) {
        EXPECT_THROW(LineMap({{{{0, 0}, {2, 0}}, 0.03, Interval::everything(), curvature}}),
                     std::invalid_argument);
    }
}

}  // namespace offmap::core
