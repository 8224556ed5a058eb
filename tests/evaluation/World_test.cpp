// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/World.h>

#include <gtest/gtest.h>
#include <mrpt/poses/CPose2D.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;
using mrpt::poses::CPose2D;

const TVector3D ahead{1, 0, 0};

TPoint2D moved(const CPose2D& by, const TPoint2D& point) {
    return TPoint2D(by.composePoint(point));
}

/// One of everything around the origin.
World sceneMovedBy(const CPose2D& by) {
    World world;
    world.addFloor();
    world.addCeiling(3);
    world.addMappedPanel({{moved(by, {4, -3}), moved(by, {5, 3})}, {0, 3}});
    world.addPanel({{moved(by, {-4, 3}), moved(by, {-4, -3})}, {0, 2}});
    world.addObject(Cylinder{moved(by, {1, 2}), 0.25, {0, 1.75}});
    world.addObject(Box{(by + CPose2D(2, -1, 0.4)).asTPose(), 0.6, 0.4, {0, 0.9}});
    return world;
}

}  // namespace

TEST(World, emptyWorldIsMetNowhere) { EXPECT_FALSE(World{}.castRay({0, 0, 1}, ahead, 1e6)); }

TEST(World, nearestSurfaceIsMet) {
    World world;
    const uint32_t far = world.addPanel({{{5, -1}, {5, 1}}, {0, 2}});
    const uint32_t near = world.addObject(Cylinder{{3, 0}, 0.5, {0, 1.5}});
    world.addPanel({{{8, -1}, {8, 1}}, {0, 2}});

    const auto low = world.castRay({0, 0, 1}, ahead, 100);
    EXPECT_EQ(low.value().surface, near);
    EXPECT_DOUBLE_EQ(low->range, 2.5);
    const auto overTheCylinder = world.castRay({0, 0, 1.8}, ahead, 100);
    EXPECT_EQ(overTheCylinder.value().surface, far);
    EXPECT_DOUBLE_EQ(overTheCylinder->range, 5);
}

TEST(World, beyondMaxRangeNothingIsMet) {
    World world;
    world.addPanel({{{5, -1}, {5, 1}}, {0, 2}});
    EXPECT_TRUE(world.castRay({0, 0, 1}, ahead, 5));
    EXPECT_FALSE(world.castRay({0, 0, 1}, ahead, 4.999));
}

TEST(World, surfacesKnowTheirKindAndWall) {
    World world;
    const uint32_t wall = world.addToMap({.line = {{0, 0}, {9, 0}}});
    const Panel panel{{{0, 0}, {4, 0}}, {0, 2}};
    const uint32_t shown = world.addPanel(panel, wall);
    const uint32_t notShown = world.addPanel(panel);
    const uint32_t leaf = world.addObject(panel);
    const uint32_t floor = world.addFloor();
    const uint32_t ceiling = world.addCeiling(3);

    const auto& surfaces = world.surfaces();
    EXPECT_EQ(surfaces[shown].kind, SurfaceKind::Wall);
    EXPECT_EQ(surfaces[shown].wall, wall);
    EXPECT_TRUE(surfaces[shown].mapped());
    EXPECT_EQ(surfaces[notShown].kind, SurfaceKind::Wall);
    EXPECT_EQ(surfaces[leaf].kind, SurfaceKind::Object);
    EXPECT_EQ(surfaces[floor].kind, SurfaceKind::Floor);
    EXPECT_EQ(surfaces[ceiling].kind, SurfaceKind::Ceiling);
    for (const uint32_t id : {notShown, leaf, floor, ceiling}) EXPECT_FALSE(surfaces[id].mapped());
}

TEST(World, mapHoldsMappedWallsOnly) {
    World world;
    world.addPanel({{{0, 0}, {4, 0}}, {0, 2}});
    world.addObject(Box{{1, 1, 0}, 1, 1, {0, 1}});
    const uint32_t shown = world.addMappedPanel({{{7, 0}, {7, 2}}, {0, 2}});
    world.addToMap({.line = {{0, 9}, {9, 9}}});

    const auto map = mapOf(world);
    ASSERT_EQ(map.size(), 2u);
    EXPECT_EQ(world.surfaces()[shown].wall, 0u);
    EXPECT_EQ(map[0].line.point1, TPoint2D(7, 0));
    EXPECT_EQ(map[0].line.point2, TPoint2D(7, 2));
    EXPECT_EQ(map[1].line.point1, TPoint2D(0, 9));
}

TEST(World, shapeWithoutExtentIsRefused) {
    World world;
    EXPECT_THROW(world.addPanel({{{1, 1}, {1, 1}}, {0, 2}}), std::invalid_argument);
    EXPECT_THROW(world.addObject(Panel{{{1, 1}, {2, 1}}, {0, 0}}), std::invalid_argument);
    EXPECT_THROW(world.addObject(Cylinder{{1, 1}, 0, {0, 2}}), std::invalid_argument);
    EXPECT_THROW(world.addObject(Box{{1, 1, 0}, 1, -1, {0, 2}}), std::invalid_argument);
    EXPECT_THROW(world.addPanel({{{1, 1}, {2, 1}}, {0, 2}}, 0), std::invalid_argument);
    EXPECT_TRUE(world.surfaces().empty());
}

TEST(World, movingWorldAndRayTogetherChangesNothing) {
    const World still = sceneMovedBy(CPose2D());
    for (const CPose2D& by : {CPose2D(0, 0, 1), CPose2D(30, -20, -2.5), CPose2D(-7, 3, 3.1)}) {
        const World other = sceneMovedBy(by);
        for (int i = 0; i < 1000; ++i) {
            // azimuths and elevations that a golden-angle step spreads, so none hits an edge
            // exactly
            const double azimuth = 2.399963 * i, elevation = std::asin(-0.95 + 1.9e-3 * i);
            const auto direction = [&](double turn) {
                return TVector3D(std::cos(elevation) * std::cos(azimuth + turn),
                                 std::cos(elevation) * std::sin(azimuth + turn),
                                 std::sin(elevation));
            };
            const auto expected = still.castRay({0, 0, 1}, direction(0), 50);
            const auto hit = other.castRay({by.x(), by.y(), 1}, direction(by.phi()), 50);
            ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
            if (!hit) continue;
            EXPECT_EQ(hit->surface, expected->surface) << i;
            // coordinates below 50 m round by 1e-14; grazing incidence costs some digits
            EXPECT_NEAR(hit->range, expected->range, 1e-10) << i;
        }
    }
}

}  // namespace offmap::evaluation
