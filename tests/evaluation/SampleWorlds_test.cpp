// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SampleWorlds.h>

#include <gtest/gtest.h>

#include <cmath>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

const TPoint3D sensorInRoom{2, 2.5, 0.6};
const TPoint3D sensorInCorridor{4, 0, 0.6};

std::optional<WorldHit> look(const World& world, const TPoint3D& from, const TPoint3D& at) {
    const TVector3D line = at - from;
    return world.castRay(from, line * (1 / line.norm()), 100);
}

/// Rays in all directions, evenly spread (Fibonacci sphere).
std::vector<TVector3D> allAround() {
    std::vector<TVector3D> directions;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const double z = -1 + (2 * i + 1.0) / count, radius = std::sqrt(1 - z * z);
        directions.emplace_back(radius * std::cos(2.399963 * i), radius * std::sin(2.399963 * i),
                                z);
    }
    return directions;
}

void expectClosed(const World& world, const TPoint3D& from, double diameter) {
    for (const TVector3D& direction : allAround()) {
        EXPECT_TRUE(world.castRay(from, direction, diameter)) << direction;
    }
}

void expectMappedPanelsStandOnTheirWall(const World& world) {
    const auto map = mapOf(world);
    for (const Surface& surface : world.surfaces()) {
        if (!surface.mapped()) continue;
        const auto& panel = std::get<Panel>(surface.shape);
        EXPECT_NEAR(map[*surface.wall].line.distance(panel.line.point1), 0, 1e-12);
        EXPECT_NEAR(map[*surface.wall].line.distance(panel.line.point2), 0, 1e-12);
    }
}

}  // namespace

TEST(OfficeRoom, isClosed) { expectClosed(officeRoom(), sensorInRoom, std::hypot(8.5, 7, 2.8)); }

TEST(OfficeRoom, mappedPanelsStandOnTheirWall) { expectMappedPanelsStandOnTheirWall(officeRoom()); }

TEST(OfficeRoom, mapShowsFourWalls) { EXPECT_EQ(mapOf(officeRoom()).size(), 4u); }

TEST(OfficeRoom, personStandsFree) {
    const World world = officeRoom();
    const auto hit = look(world, sensorInRoom, {4.5, 2.0, 0.6});
    EXPECT_EQ(world.surfaces()[hit.value().surface].kind, SurfaceKind::Object);
    EXPECT_NEAR(hit->range, std::hypot(2.5, 0.5) - 0.25, 1e-12);
}

TEST(OfficeRoom, cartonStandsHalfAMetreBeforeTheWall) {
    const World world = officeRoom();
    const auto hit = world.castRay({3.5, 0, 0.3}, {0, 1, 0}, 10);
    EXPECT_NEAR(hit.value().range, 0.5, 1e-12);
    EXPECT_EQ(world.surfaces()[hit->surface].kind, SurfaceKind::Object);
    EXPECT_EQ(world.surfaces()[look(world, sensorInRoom, {3.5, 0.7, 0.3})->surface].kind,
              SurfaceKind::Object);
}

TEST(OfficeRoom, doorwayOpensWhereTheMapShowsAWall) {
    const World world = officeRoom();
    const TPoint3D inDoorway{5.45, 5, 1.0};
    double nearestWall = 1;
    for (const core::Wall& wall : mapOf(world)) {
        nearestWall = std::min(nearestWall, wall.line.distance({inDoorway.x, inDoorway.y}));
    }
    EXPECT_NEAR(nearestWall, 0, 1e-12);

    const auto hit = look(world, sensorInRoom, inDoorway);
    EXPECT_GT(hit.value().range, (inDoorway - sensorInRoom).norm() + 1);
    EXPECT_EQ(world.surfaces()[hit->surface].kind, SurfaceKind::Wall);
    EXPECT_FALSE(world.surfaces()[hit->surface].mapped());
}

TEST(OfficeRoom, wallGoesOnAboveTheDoorway) {
    const World world = officeRoom();
    const auto above = look(world, sensorInRoom, {5.45, 5, 2.4});
    const auto beside = look(world, sensorInRoom, {3, 5, 1});
    EXPECT_NE(above.value().surface, beside.value().surface);
    EXPECT_TRUE(world.surfaces()[above->surface].mapped());
    EXPECT_EQ(world.surfaces()[above->surface].wall, world.surfaces()[beside->surface].wall);
}

TEST(OfficeRoom, doorLeafStandsInTheRoom) {
    const World world = officeRoom();
    const TPoint3D onLeaf{5.9, 4.3, 1};
    const auto hit = look(world, sensorInRoom, onLeaf);
    EXPECT_NEAR(hit.value().range, (onLeaf - sensorInRoom).norm(), 1e-12);
    EXPECT_EQ(world.surfaces()[hit->surface].kind, SurfaceKind::Object);
}

TEST(Corridor, isClosed) { expectClosed(corridor(), sensorInCorridor, std::hypot(20, 6, 2.5)); }

TEST(Corridor, mappedPanelsStandOnTheirWall) { expectMappedPanelsStandOnTheirWall(corridor()); }

TEST(Corridor, officeIsSeenThroughItsDoor) {
    const World world = corridor();
    const auto cabinet = look(world, sensorInCorridor, {8.5, -2.0, 0.6});
    EXPECT_NEAR(cabinet.value().range, std::hypot(4.5, 2.0), 1e-12);
    EXPECT_EQ(world.surfaces()[cabinet->surface].kind, SurfaceKind::Object);
}

TEST(Corridor, whatIsNotOnTheMapIsSeen) {
    const World world = corridor();
    for (const TPoint3D& at : {TPoint3D{8.0, 0.3, 1.2}, TPoint3D{7.0, -0.4, 0.3},
                               TPoint3D{18, -0.1, 1.2}, TPoint3D{0.1, 0.6, 0.9}}) {
        const auto hit = look(world, sensorInCorridor, at);
        EXPECT_EQ(world.surfaces()[hit.value().surface].kind, SurfaceKind::Object) << at;
    }
    const auto wall = look(world, sensorInCorridor, {5, 1, 1});
    EXPECT_TRUE(world.surfaces()[wall.value().surface].mapped());
}

}  // namespace offmap::evaluation
