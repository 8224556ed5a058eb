// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <numbers>

namespace offmap::evaluation {

namespace {

using mrpt::poses::CPose3D;

/// A handful of roundings at coordinates below 10 m.
constexpr double rounding = 1e-14;

void expectNear(const CPose3D& a, const CPose3D& b) {
    for (unsigned i = 0; i < 6; ++i) EXPECT_NEAR(a[i], b[i], rounding) << i;
}

/// Four beams straight ahead in one second, towards a wall at x = 3.
const Scanner fourTimesAhead{{0, 0, 0, 0}, {0}, 100, 1};

World wallAhead() {
    World world;
    world.addMappedPanel({{{3, -10}, {3, 10}}, {-10, 10}});
    return world;
}

}  // namespace

TEST(OnVehicle, sensorAtTheOriginMovesAsTheVehicle) {
    const Trajectory straight =
        onVehicle({.sensorInMap = CPose3D(1, 2, 0.6, std::numbers::pi / 2)}, {.speed = 2});
    expectNear(straight(1.5).sensorInMap, CPose3D(1, 5, 0.6, std::numbers::pi / 2));
}

TEST(OnVehicle, sensorAtALeverArmSwingsAround) {
    // the vehicle turns by a right angle on the spot at (1, 2); the sensor is 0.5 m before it
    const CPose3D mount(0.5, 0, 0.6, 0, 0.1, 0);
    const core::SensorPose start{.sensorInMap = CPose3D(1, 2, 0, 0, 0, 0) + mount};
    const Trajectory turning = onVehicle(start, {.yawRate = std::numbers::pi / 4}, mount);
    expectNear(turning(0).sensorInMap, start.sensorInMap);
    expectNear(turning(2).sensorInMap, CPose3D(1, 2.5, 0.6, std::numbers::pi / 2, 0.1, 0));
}

TEST(OnVehicle, covarianceStays) {
    core::SensorPose start;
    start.groundCovariance(1, 1) = 0.01;
    EXPECT_EQ(onVehicle(start, {.speed = 1})(2).groundCovariance, start.groundCovariance);
}

TEST(SimulateMoving, rangesShrinkOnTheWayToAWall) {
    const auto scan =
        simulateMoving(wallAhead(), fourTimesAhead, onVehicle({}, {.speed = 0.8}), {}, 1).scan;
    ASSERT_EQ(scan.points.size(), 4u);
    for (size_t c = 0; c < 4; ++c) {
        const double way = 0.2 * static_cast<double>(c);  // 0.8 m/s for a quarter of a second each
        EXPECT_FLOAT_EQ(scan.points[c].x, static_cast<float>(3 - way));
        expectNear(scan.columns[c].sensor.value().sensorInMap, CPose3D(way, 0, 0));
    }
}

TEST(SimulateMoving, pointsStandOnTheirSurfaceByThePoseOfTheirColumn) {
    const World world = officeRoom();
    const Trajectory way =
        onVehicle({.sensorInMap = CPose3D(2, 2, 0.6, 0.2)}, {.speed = 0.5, .yawRate = 0.3});
    const auto [scan, truth] = simulateMoving(world, paperScanner(), way, {}, 1);
    size_t walls = 0;
    for (const core::ScanColumn& column : scan.columns) {
        for (uint32_t i = column.begin; i < column.end; ++i) {
            if (truth[i].kind != SurfaceKind::Wall) continue;
            const auto& panel = std::get<Panel>(world.surfaces()[truth[i].surface].shape);
            const auto point = column.sensor.value().sensorInMap.composePoint(
                mrpt::math::TPoint3D(scan.points[i]));
            // single precision of two coordinates below 10 m
            EXPECT_NEAR(panel.line.distance({point.x, point.y}), 0,
                        20 * std::numeric_limits<float>::epsilon());
            ++walls;
        }
    }
    EXPECT_GT(walls, 1000u);
}

TEST(SimulateMoving, standingStillIsSimulate) {
    const core::SensorPose sensor{.sensorInMap = CPose3D(2, 2.5, 0.6, 0.4)};
    const ScannerNoise noise{.range = 0.02, .angle = 0.001};
    const auto still = simulate(officeRoom(), vlp16(), sensor, noise, 3).scan;
    const auto moving = simulateMoving(
                            officeRoom(), vlp16(), [&](double) { return sensor; }, noise, 3)
                            .scan;
    EXPECT_EQ(moving.points, still.points);
}

TEST(SetTrajectory, columnsFollowByTheirTime) {
    auto scan = simulate(wallAhead(), fourTimesAhead, {}, {}, 1).scan;
    for (auto& column : scan.columns) column.time += std::chrono::hours(1000);
    setTrajectory(scan, onVehicle({.sensorInMap = CPose3D(0, 1, 0)}, {.speed = 0.8}));
    expectNear(scan.columns[3].sensor.value().sensorInMap, CPose3D(0.6, 1, 0));
    setSensor(scan, {});  // held
    expectNear(scan.columns[3].sensor.value().sensorInMap, CPose3D());
}

}  // namespace offmap::evaluation
