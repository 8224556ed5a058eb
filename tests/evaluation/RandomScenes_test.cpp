// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/RandomScenes.h>
#include <offmap/evaluation/SimulatedScan.h>
#include <offmap/evaluation/StandOff.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

constexpr uint64_t seeds = 150;
/// A handful of roundings at coordinates below 50 m.
constexpr double rounding = 1e-12;

std::vector<double> standOffsIn(const World& world) {
    std::vector<double> standOffs;
    for (uint32_t id = 0; id < world.surfaces().size(); ++id) {
        if (const auto standOff = standOffOf(world, id)) standOffs.push_back(*standOff);
    }
    return standOffs;
}

double nearestWall(const World& world, const mrpt::math::TPoint2D& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const core::Wall& wall : mapOf(world)) {
        nearest = std::min(nearest, wall.line.distance(place));
    }
    return nearest;
}

double ceilingOf(const World& world) {
    for (const Surface& surface : world.surfaces()) {
        if (surface.kind == SurfaceKind::Ceiling) return std::get<Plane>(surface.shape).z;
    }
    return 0;
}

}  // namespace

TEST(RandomScene, everyBeamReturns) {
    for (uint64_t seed = 0; seed < 30; ++seed) {
        const Scene scene = randomScene(seed);
        const auto scan = simulate(scene.world, paperScanner(), scene.sensor, {}, 1).scan;
        EXPECT_EQ(scan.points.size(), 32761u) << seed;
    }
}

TEST(RandomScene, objectsStandAtTheGivenGapsOrInTheOpen) {
    std::map<double, size_t> count;
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        const auto standOffs = standOffsIn(randomScene(seed).world);
        EXPECT_GE(standOffs.size(), 3u) << seed;
        EXPECT_LE(standOffs.size(), 6u) << seed;
        for (const double standOff : standOffs) {
            const double given = standOff < 0.55 ? std::round(standOff * 100) / 100 : 1;
            EXPECT_TRUE(given == 1 || std::abs(standOff - given) < rounding) << seed;
            ++count[given];
        }
    }
    ASSERT_EQ(count.size(), 6u);  // five gaps and the open
    for (const auto& [standOff, n] : count) {
        // 3 objects before a wall per scene over 5 gaps: 90 each, the least likely gap no less than
        // 5 standard deviations below
        EXPECT_GT(n, 90 - 5 * std::sqrt(450 * 0.2 * 0.8)) << standOff;
    }
}

TEST(RandomScene, oneGapServesAllObjectsBeforeWalls) {
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        size_t before = 0;
        for (const double standOff : standOffsIn(randomScene(seed, {{0.03}}).world)) {
            if (standOff >= 0.55) continue;
            EXPECT_NEAR(standOff, 0.03, rounding) << seed;
            ++before;
        }
        EXPECT_GE(before, 2u) << seed;
    }
}

TEST(RandomScene, sensorStandsFreeAndLevel) {
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        const auto [world, sensor] = randomScene(seed);
        const auto& pose = sensor.sensorInMap;
        EXPECT_GE(nearestWall(world, {pose.x(), pose.y()}), 0.6 - rounding) << seed;
        EXPECT_GE(pose.z(), 0.5);
        EXPECT_LT(pose.z(), 1.2);
        EXPECT_EQ(pose.pitch(), 0);
        EXPECT_EQ(pose.roll(), 0);
        EXPECT_TRUE(sensor.groundCovariance.isZero());
        EXPECT_GE(ceilingOf(world), 2.4);
        EXPECT_LT(ceilingOf(world), 3.2);
    }
}

TEST(RandomScene, mapHasTheWallsOfItsKind) {
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        EXPECT_EQ(mapOf(randomScene(seed).world).size(), seed % 3 == 2 ? 6u : 4u);
        double longest = 0;
        for (const core::Wall& wall : mapOf(randomCorridor(seed).world)) {
            longest = std::max(longest, wall.line.length());
        }
        EXPECT_GE(longest, 15 - rounding);
        EXPECT_LE(longest, 25 + rounding);
    }
}

TEST(RandomScene, seedDeterminesIt) {
    const auto scanOf = [](uint64_t seed) {
        const Scene scene = randomScene(seed);
        return simulate(scene.world, vlp16(), scene.sensor, {}, 1).scan.points;
    };
    EXPECT_EQ(scanOf(4), scanOf(4));
    EXPECT_NE(scanOf(4), scanOf(7));
}

TEST(RandomScene, unusableGapsAreRefused) {
    EXPECT_THROW(randomScene(1, {{}}), std::invalid_argument);
    EXPECT_THROW(randomRoom(1, {{0.0}}), std::invalid_argument);
    EXPECT_THROW(randomCorner(1, {{0.1, 0.6}}), std::invalid_argument);
    EXPECT_THROW(randomCorridor(1, {{std::nan("")}}), std::invalid_argument);
}

TEST(RandomScene, pointsKnowTheGapOfTheirObject) {
    const Scene scene = randomScene(3, {{0.1}});
    const auto truth = simulate(scene.world, paperScanner(), scene.sensor, {}, 1).truth;
    size_t before = 0;
    for (const PointTruth& point : truth) {
        EXPECT_EQ(point.standOff.has_value(), point.kind == SurfaceKind::Object);
        if (point.standOff && *point.standOff < 0.5F) {
            EXPECT_FLOAT_EQ(*point.standOff, 0.1F);
            ++before;
        }
    }
    EXPECT_GT(before, 0u);
}

}  // namespace offmap::evaluation
