// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <gtest/gtest.h>
#include <mrpt/poses/CPose2D.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::poses::CPose3D;

/// A coordinate in single precision, [m] from here to the next.
double floatRounding(double range) { return range * std::numeric_limits<float>::epsilon(); }

core::SensorPose at(const CPose3D& sensorInMap) { return {.sensorInMap = sensorInMap}; }

/// A wall at x = 3 that reaches further than any beam of these tests.
World wallAhead() {
    World world;
    world.addMappedPanel({{{3, -1000}, {3, 1000}}, {-1000, 1000}});
    return world;
}

void expectEqual(const SimulatedScan& a, const SimulatedScan& b) {
    EXPECT_EQ(a.scan.points, b.scan.points);
    EXPECT_EQ(a.scan.sourceIndex, b.scan.sourceIndex);
}

}  // namespace

TEST(Simulate, wallAheadIsMeasuredAtItsDistanceOverTheCosine) {
    const Scanner scanner{{0.7, 0.0, -0.7}, {-1.0, -0.3, 0.0, 0.3, 1.0}, 1000, 1};
    const auto [scan, truth] = simulate(wallAhead(), scanner, at(CPose3D()), {}, 1);
    ASSERT_EQ(scan.points.size(), 15u);
    for (size_t i = 0; i < scan.points.size(); ++i) {
        const double azimuth = scanner.azimuths[i / 5], elevation = scanner.elevations[i % 5];
        const double range = 3 / std::cos(elevation) / std::cos(azimuth);
        EXPECT_NEAR(scan.points[i].norm(), range, 2 * floatRounding(range));
        EXPECT_NEAR(scan.points[i].x, 3, floatRounding(range));
        EXPECT_NEAR(scan.points[i].z, range * std::sin(elevation), floatRounding(range));
        EXPECT_TRUE(truth[i].mapped);
    }
}

TEST(Simulate, columnsFollowEachOtherAndCoverThePoints) {
    const Scanner scanner = paperScanner();
    const auto [scan, truth] = simulate(officeRoom(), scanner, at(CPose3D(2, 2.5, 0.6)), {}, 1);
    EXPECT_EQ(scan.points.size(), 32761u);  // the room is closed: every beam returns
    EXPECT_EQ(scan.sourceIndex.size(), scan.points.size());
    EXPECT_EQ(truth.size(), scan.points.size());
    ASSERT_EQ(scan.columns.size(), scanner.azimuths.size());
    uint32_t end = 0;
    for (size_t c = 0; c < scan.columns.size(); ++c) {
        EXPECT_EQ(scan.columns[c].begin, end);
        EXPECT_FLOAT_EQ(scan.columns[c].azimuth, static_cast<float>(scanner.azimuths[c]));
        EXPECT_TRUE(c == 0 || scan.columns[c].time > scan.columns[c - 1].time);
        end = scan.columns[c].end;
    }
    EXPECT_EQ(end, scan.points.size());
}

TEST(Simulate, beamWithoutReturnLeavesItsIndexOut) {
    World world;  // one panel, so high that only the upper beam passes over it
    world.addPanel({{{3, -1}, {3, 1}}, {-1, 1}});
    const Scanner scanner{{3.0, 0.0}, {-0.2, 0.2, 0.6}, 1000, 1};
    const SimulatedScan result = simulate(world, scanner, at(CPose3D()), {}, 1);
    EXPECT_EQ(result.scan.sourceIndex, (std::vector<uint32_t>{3, 4}));
    EXPECT_EQ(result.scan.columns[0].end, 0u);
    EXPECT_EQ(result.scan.columns[1].end, 2u);
}

TEST(Simulate, nothingReturnsFromBeyondMaxRange) {
    const Scanner scanner{{0.0}, {0.0}, 2.9, 1};
    EXPECT_TRUE(simulate(wallAhead(), scanner, at(CPose3D()), {}, 1).scan.points.empty());
}

TEST(Simulate, pointsOfATiltedSensorLieOnTheirSurface) {
    const World world = officeRoom();
    const CPose3D sensorInMap(2, 2.5, 0.6, 1.2, 0.3, -0.2);
    const auto [scan, truth] = simulate(world, paperScanner(), at(sensorInMap), {}, 1);
    size_t walls = 0, floors = 0;
    for (size_t i = 0; i < scan.points.size(); ++i) {
        const auto point = sensorInMap.composePoint(scan.points[i].cast<double>());
        const double tolerance = 3 * floatRounding(10);  // three coordinates, below 10 m each
        if (truth[i].kind == SurfaceKind::Floor) {
            EXPECT_NEAR(point.z, 0, tolerance);
            ++floors;
        } else if (truth[i].kind == SurfaceKind::Wall) {
            const auto& panel = std::get<Panel>(world.surfaces()[truth[i].surface].shape);
            EXPECT_NEAR(panel.line.distance({point.x, point.y}), 0, tolerance);
            ++walls;
        }
    }
    EXPECT_GT(walls, 0u);
    EXPECT_GT(floors, 0u);
}

TEST(Simulate, turningWorldAndSensorTogetherChangesNoRange) {
    const auto roomTurnedBy = [](double angle) {
        const mrpt::poses::CPose2D turn(0, 0, angle);
        const auto corner = [&](double x, double y) {
            return mrpt::math::TPoint2D(turn.composePoint(mrpt::math::TPoint2D(x, y)));
        };
        World world;
        world.addFloor();
        world.addMappedPanel({{corner(-3, -2), corner(4, -2)}, {0, 2.5}});
        world.addMappedPanel({{corner(4, -2), corner(4, 3)}, {0, 2.5}});
        world.addObject(personAt(corner(2, 0.5)));
        return world;
    };
    const auto scanAt = [&](double angle) {
        return simulate(roomTurnedBy(angle), paperScanner(), at(CPose3D(0, 0, 1, angle)),
                        {.range = 0.02, .angle = 0.001}, 5);
    };
    const SimulatedScan still = scanAt(0), turned = scanAt(1.1);
    ASSERT_EQ(turned.scan.sourceIndex, still.scan.sourceIndex);
    for (size_t i = 0; i < still.scan.points.size(); ++i) {
        const double range = still.scan.points[i].norm();
        EXPECT_NEAR(turned.scan.points[i].norm(), range, 4 * floatRounding(range));
        EXPECT_EQ(turned.truth[i].surface, still.truth[i].surface);
    }
}

TEST(Simulate, seedDeterminesTheScan) {
    const auto scanOf = [](uint64_t seed) {
        return simulate(corridor(), vlp16(), at(CPose3D(4, 0, 0.6)), {0.02, 0.001}, seed);
    };
    const SimulatedScan first = scanOf(11);
    expectEqual(first, scanOf(11));
    EXPECT_NE(first.scan.points, scanOf(12).scan.points);
}

TEST(Simulate, withoutNoiseTheSeedIsIdle) {
    const auto scanOf = [](uint64_t seed) {
        return simulate(corridor(), paperScanner(), at(CPose3D(4, 0, 0.6)), {}, seed);
    };
    expectEqual(scanOf(1), scanOf(2));
}

TEST(Simulate, columnsCarryTheSensor) {
    core::SensorPose sensor = at(CPose3D(2, 2.5, 0.6, 0.4));
    sensor.groundCovariance(1, 1) = 0.01;
    SimulatedScan result = simulate(officeRoom(), paperScanner(), sensor, {}, 1);
    for (const core::ScanColumn& column : result.scan.columns) {
        EXPECT_EQ(column.sensor.value().sensorInMap, sensor.sensorInMap);
        EXPECT_EQ(column.sensor->groundCovariance, sensor.groundCovariance);
    }
    setSensor(result.scan, at(CPose3D()));
    EXPECT_EQ(result.scan.columns.back().sensor.value().sensorInMap, CPose3D());
}

TEST(Simulate, negativeNoiseIsRefused) {
    EXPECT_THROW(simulate(wallAhead(), vlp16(), at(CPose3D()), {.range = -0.01}, 1),
                 std::invalid_argument);
    EXPECT_THROW(simulate(wallAhead(), vlp16(), at(CPose3D()),
                          {.angle = std::numeric_limits<double>::quiet_NaN()}, 1),
                 std::invalid_argument);
}

}  // namespace offmap::evaluation
