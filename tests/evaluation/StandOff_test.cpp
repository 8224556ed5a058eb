// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/StandOff.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::math::TSegment2D;

const TSegment2D wallAlongX{{-5, 0}, {5, 0}};
/// A handful of roundings at coordinates below 10 m.
constexpr double rounding = 1e-14;

}  // namespace

TEST(Gap, uprightCylinderIsItsRadiusNearerThanItsAxis) {
    EXPECT_NEAR(gap(Cylinder{{1, 2}, 0.25, {0, 1}}, wallAlongX), 1.75, rounding);
    EXPECT_NEAR(gap(Cylinder{{8, 4}, 0.25, {0, 1}}, wallAlongX), 4.75, rounding);  // beside: 3-4-5
    EXPECT_EQ(gap(Cylinder{{1, 0.2}, 0.25, {0, 1}}, wallAlongX), 0);
}

TEST(Gap, leaningCylinderIsNearestWithItsHead) {
    const Cylinder person{{1, 1}, 0.25, {0.5, 2.5}, {0, -0.3}};  // 2 m high: 0.6 m over
    EXPECT_NEAR(gap(person, wallAlongX), 1 - 0.6 - 0.25, rounding);
}

TEST(Gap, boxIsNearestWithItsFaceOrCorner) {
    EXPECT_NEAR(gap(Box{{1, 2, 0}, 3, 1, {0, 1}}, wallAlongX), 1.5, rounding);
    EXPECT_NEAR(gap(Box{{1, 2, std::numbers::pi / 4}, 1, 1, {0, 1}}, wallAlongX),
                2 - std::sqrt(0.5), rounding);
    EXPECT_EQ(gap(Box{{1, 0.3, 0}, 3, 1, {0, 1}}, wallAlongX), 0);
    EXPECT_EQ(gap(Box{{0, 0, 0}, 30, 30, {0, 1}}, wallAlongX), 0);  // the wall stands within
}

TEST(Gap, panelIsNearestWithItsEndUnlessItCrosses) {
    EXPECT_NEAR(gap(Panel{{{1, 0.5}, {1, 2}}, {0, 1}}, wallAlongX), 0.5, rounding);
    EXPECT_EQ(gap(Panel{{{1, -1}, {1, 2}}, {0, 1}}, wallAlongX), 0);
}

TEST(StandOffOf, isThatOfTheNearestWallOfTheMap) {
    World world;
    world.addMappedPanel({{{-5, 0}, {5, 0}}, {0, 2}});
    world.addMappedPanel({{{-5, 3}, {5, 3}}, {0, 2}});
    world.addPanel({{{-5, 2}, {5, 2}}, {0, 2}});  // not on the map
    const uint32_t box = world.addObject(Box{{0, 1.8, 0}, 1, 1, {0, 1}});
    EXPECT_NEAR(standOffOf(world, box).value(), 0.7, rounding);
}

TEST(StandOffOf, bentWallIsMeasuredOnItsArc) {
    World world;  // half a circle of 1 m radius around the origin, to the left of its chord
    world.addToMap({.line = {{0, -1}, {0, 1}}, .curvature = 1});
    const uint32_t inside = world.addObject(Cylinder{{0.6, 0}, 0.1, {0, 1}});
    // chords of a 256th of half a circle are off by 1 - cos(pi / 512)
    EXPECT_NEAR(standOffOf(world, inside).value(), 0.3, 2e-5);
}

TEST(StandOffOf, onlyObjectsBeforeAMapHaveOne) {
    World world;
    const uint32_t object = world.addObject(Cylinder{{0, 1}, 0.2, {0, 1}});
    EXPECT_FALSE(standOffOf(world, object));
    const uint32_t wall = world.addMappedPanel({{{-5, 0}, {5, 0}}, {0, 2}});
    EXPECT_TRUE(standOffOf(world, object));
    EXPECT_FALSE(standOffOf(world, wall));
    EXPECT_FALSE(standOffOf(world, world.addFloor()));
    EXPECT_THROW(standOffOf(world, 99), std::out_of_range);
}

}  // namespace offmap::evaluation
