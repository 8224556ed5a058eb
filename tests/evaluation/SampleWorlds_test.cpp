// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/StandOff.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

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

TEST(ParkingLot, warehousesAreOnTheMapAndAllElseIsNot) {
    const World world = parkingLot();
    expectMappedPanelsStandOnTheirWall(world);
    const TPoint3D sensor{0, 0, 1};
    const auto kindAt = [&](const TPoint3D& at) {
        return world.surfaces()[look(world, sensor, at).value().surface].kind;
    };
    EXPECT_EQ(kindAt({-25, 22, 5}), SurfaceKind::Wall);
    EXPECT_EQ(kindAt({-6, 12, 0.7}), SurfaceKind::Object);  // a car
    EXPECT_EQ(kindAt({5, 3, 1}), SurfaceKind::Object);      // a person
    EXPECT_EQ(kindAt({20, 8, 2}), SurfaceKind::Object);     // the lorry
    EXPECT_EQ(kindAt({2, -12, 1.0}), SurfaceKind::Object);  // a post of the fence
    EXPECT_FALSE(look(world, sensor, {30, 0, 10}));         // the sky
}

TEST(ParkingLot, fenceIsSeenAndSeenThrough) {
    const World world = parkingLot();
    size_t fence = 0, behind = 0;
    for (const TVector3D& direction : allAround()) {
        if (direction.y > -0.9 || std::abs(direction.z) > 0.05) continue;
        const auto hit = world.castRay({-22, -10, 1}, direction, 100);
        if (!hit) continue;
        // the fence is 2 m away, to the side at most 2 / 0.9; the warehouse 14 m
        (hit->range < 2.3 ? fence : behind) += 1;
    }
    EXPECT_GT(fence, 0u);
    EXPECT_GT(behind, fence);  // wires of 0.03 m every 0.2 m leave (17 / 20)^2 = 72 % open
}

TEST(BareCorridor, looksTheSameAllAlong) {
    const World world = bareCorridor();
    for (const TVector3D& direction : allAround()) {
        const auto here = world.castRay({0, 0.2, 0.8}, direction, 100);
        const auto there = world.castRay({50, 0.2, 0.8}, direction, 100);
        ASSERT_EQ(here.has_value(), there.has_value());
        if (!here) continue;
        // a grazing ray of 100 m: 100 m / 1.4 m times the rounding of coordinates below 200 m
        EXPECT_NEAR(here->range, there->range, 1e-10);
    }
}

TEST(CurvedHall, isClosed) { expectClosed(curvedHall(), {-1, -2, 0.8}, std::hypot(16, 10, 4)); }

TEST(CurvedHall, wallLiesOnTheArc) {
    const World world = curvedHall();
    for (const double phi : {0.7, 1.2, 1.9, 2.4}) {
        const auto hit = world.castRay({0, -6, 2}, {std::cos(phi), std::sin(phi), 0}, 100);
        // 64 pieces of 1.66 degrees: 10 m * (1 - cos(0.83 deg)) = 1.04 mm inside at most
        EXPECT_LE(hit.value().range, 10 + 1e-12);
        EXPECT_GE(hit->range, 10 - 1.05e-3);
        EXPECT_TRUE(world.surfaces()[hit->surface].mapped());
    }
}

TEST(CurvedHall, mapShowsChordsOrTheArc) {
    EXPECT_EQ(mapOf(curvedHall()).size(), 3u + 8u);
    const auto bent = mapOf(curvedHall(0));
    ASSERT_EQ(bent.size(), 4u);
    // from (8, 0) counter-clockwise over (0, 4) to (-8, 0)
    EXPECT_NEAR(core::distanceTo(bent[3], {0, 4}), 0, 1e-12);
    EXPECT_THROW(curvedHall(5), std::invalid_argument);
}

TEST(CurvedHall, crateStandsBeforeTheArc) {
    const auto hit = curvedHall().castRay({0, -2, 0.5}, {0, 1, 0}, 10);
    EXPECT_NEAR(hit.value().range, 5.2, 1e-12);
    const World world = curvedHall(0);
    // its corners at (+-0.4, 3.8) are sqrt(0.4^2 + 9.8^2) from the centre; arc in 256 chords:
    // 10 m * (1 - cos(53.1 deg / 256)) = 0.07 mm
    EXPECT_NEAR(standOffOf(world, hit->surface).value(), 10 - std::hypot(0.4, 9.8), 1e-4);
}

}  // namespace offmap::evaluation
