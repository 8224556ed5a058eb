// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/WallGeometry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double maxRange = 100;
constexpr int chords = 1000;

struct RandomArc {
    explicit RandomArc(unsigned seed) : random(seed) {
        arc = {{between(-5, 5), between(-5, 5)},
               between(0.2, 12),
               between(-7, 7),
               seed % 4 == 0 ? 2 * pi : between(0.1, 2 * pi)};
        walls = wallsAlong(arc, {});
        TPoint2D from = onCircle(arc.radius, 0);
        for (int i = 1; i <= chords; ++i) {
            const TPoint2D to = onCircle(arc.radius, arc.sweep * i / chords);
            polyline.push_back({{from, to}});
            from = to;
        }
    }
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    TPoint2D onCircle(double radius, double angle) const {
        return {arc.centre.x + radius * std::cos(arc.start + angle),
                arc.centre.y + radius * std::sin(arc.start + angle)};
    }
    /// [m] What the chords stay within the arc.
    double sagitta() const { return arc.radius * (1 - std::cos(arc.sweep / chords / 2)); }
    /// Whether a ray passes by an end of the arc so near that it may meet one of the two alone.
    bool passesAnEnd(const TPoint2D& origin, const TPoint2D& direction) const {
        const auto near = [&](const TPoint2D& end) {
            const TPoint2D to = end - origin;
            return std::abs(direction.x * to.y - direction.y * to.x) < 2 * sagitta();
        };
        return near(walls.front().line.point1) || near(walls.back().line.point2);
    }
    std::mt19937 random;
    CircularArc arc{};
    std::vector<Wall> walls, polyline;
};

}  // namespace

// At an angle rho, the sagitta s moves the hit by s / sin(rho). Near the tangent, one of the two
// may be missed, or another part of the circle hit: such rays are left out.
TEST(ArcOracle, raysMeetAnArcWhereTheyMeetAThousandChords) {
    constexpr double grazing = 0.1;  // [rad] s / sin^2 there, s <= 6e-5 m, is less than half of it
    int hits = 0, misses = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        RandomArc world(seed);
        const LineMap arcs(world.walls), lines(world.polyline);
        for (int i = 0; i < 200; ++i) {
            const TPoint2D origin(world.between(-15, 15), world.between(-15, 15));
            const double angle = world.between(0, 2 * pi);
            const TPoint2D direction(std::cos(angle), std::sin(angle));
            const auto byArc = arcs.castRay(origin, direction, maxRange, 0);
            const auto byLine = lines.castRay(origin, direction, maxRange, 0);
            const double left = (world.arc.centre.y - origin.y) * direction.x -
                                (world.arc.centre.x - origin.x) * direction.y;
            if (std::abs(left) > world.arc.radius * std::cos(grazing) &&
                std::abs(left) < world.arc.radius * (1 + grazing)) {
                continue;
            }
            if (world.passesAnEnd(origin, direction)) continue;
            if (std::abs((origin - world.arc.centre).norm() - world.arc.radius) < 1e-3) continue;
            ASSERT_EQ(byArc.has_value(), byLine.has_value()) << "arc " << seed << " ray " << i;
            byArc ? ++hits : ++misses;
            if (!byArc) continue;
            const double shift = 2 * world.sagitta() / byArc->incidence.sine();
            ASSERT_NEAR(byArc->range, byLine->range, shift) << "arc " << seed << " ray " << i;
            const double chordAngle = world.arc.sweep / chords;
            ASSERT_NEAR(byArc->incidence.angle(), byLine->incidence.angle(), chordAngle);
        }
    }
    EXPECT_GT(hits, 3000);
    EXPECT_GT(misses, 3000);
}

TEST(ArcOracle, distancesAreThoseToAThousandChords) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        RandomArc world(seed);
        const LineMap arcs(world.walls), lines(world.polyline);
        for (int i = 0; i < 50; ++i) {
            const TPoint2D place(world.between(-15, 15), world.between(-15, 15));
            const auto byArc = arcs.nearestWall(place, maxRange, 0);
            const auto byLine = lines.nearestWall(place, maxRange, 0);
            ASSERT_TRUE(byArc && byLine);
            ASSERT_NEAR(byArc->distance, byLine->distance, 1.01 * world.sagitta());
            EXPECT_TRUE(arcs.hasWallWithin(place, byArc->distance));
            EXPECT_FALSE(arcs.hasWallWithin(place, byArc->distance * (1 - 1e-9)));
        }
    }
}

// The map's index finds a wall by its bounds: no place of the wall may lie out of them.
TEST(ArcOracle, boundsAreTight) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const RandomArc world(seed);
        for (const Wall& wall : world.walls) {
            const auto [low, high] = boundsOf(wall);
            TPoint2D least = wall.line.point1, most = least;
            for (int i = 0; i <= chords; ++i) {
                const TPoint2D place = placeAt(wall, double(i) / chords);
                least = {std::min(least.x, place.x), std::min(least.y, place.y)};
                most = {std::max(most.x, place.x), std::max(most.y, place.y)};
            }
            const double between = world.sagitta() + 1e-13;
            EXPECT_LE(low.x, least.x + 1e-13);
            EXPECT_LE(low.y, least.y + 1e-13);
            EXPECT_GE(high.x, most.x - 1e-13);
            EXPECT_GE(high.y, most.y - 1e-13);
            EXPECT_NEAR(low.x, least.x, between);
            EXPECT_NEAR(low.y, least.y, between);
            EXPECT_NEAR(high.x, most.x, between);
            EXPECT_NEAR(high.y, most.y, between);
        }
    }
}

// Turned, shifted and mirrored, a wall answers the same.
TEST(ArcOracle, answersDoNotDependOnTheAxes) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        RandomArc world(seed);
        const double angle = world.between(-pi, pi), c = std::cos(angle), s = std::sin(angle);
        const TPoint2D shift(world.between(-20, 20), world.between(-20, 20));
        const double mirror = seed % 2 == 0 ? 1 : -1;
        const auto turned = [&](const TPoint2D& p) {
            return TPoint2D(c * p.x - s * mirror * p.y, s * p.x + c * mirror * p.y);
        };
        for (const Wall& here : world.walls) {
            Wall there = here;
            there.line = {turned(here.line.point1) + shift, turned(here.line.point2) + shift};
            there.curvature = mirror * here.curvature;
            const TPoint2D place(world.between(-9, 9), world.between(-9, 9));
            const double aim = world.between(0, 2 * pi);
            const TPoint2D direction(std::cos(aim), std::sin(aim));
            const TPoint2D moved = turned(place) + shift, turnedDirection = turned(direction);
            // Distances of up to 60 m: some hundred roundings, 1e3 times as many where grazing.
            EXPECT_NEAR(distanceTo(here, place), distanceTo(there, moved), 1e-11);
            EXPECT_NEAR(shareAlong(here, place), shareAlong(there, moved), 1e-11);
            const auto range = rangeTo(here, place, direction);
            const auto rangeThere = rangeTo(there, moved, turnedDirection);
            ASSERT_EQ(range.has_value(), rangeThere.has_value()) << seed;
            if (range) {
                EXPECT_NEAR(*range, *rangeThere, 1e-9);
            }
        }
    }
}

// A circle's four pieces share their ends: from inside, no ray may slip through.
TEST(ArcOracle, noRayLeavesAClosedCircle) {
    for (unsigned seed = 0; seed < 40; seed += 4) {
        RandomArc world(seed);
        const LineMap map(world.walls);
        const TPoint2D origin =
            world.onCircle(world.arc.radius * world.between(0, 0.99), world.between(0, 2 * pi));
        for (const Wall& wall : world.walls) {
            const TPoint2D to = wall.line.point1 - origin;
            const auto hit = map.castRay(origin, to * (1 / to.norm()), maxRange, 0);
            ASSERT_TRUE(hit) << "circle " << seed;
            EXPECT_NEAR(hit->range, to.norm(), 1e-12);
        }
    }
}

}  // namespace offmap::core
