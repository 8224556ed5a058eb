// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Reducer.h>
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace offmap::evaluation {

using core::PointLabel;
using mrpt::math::TPoint2D;

namespace {

constexpr double sensorHeight = 1.1, roomHeight = 2.8;  // [m]

core::SensorPose poseInRoom() {
    core::SensorPose pose;
    pose.sensorInMap.setFromValues(2, 2.5, sensorHeight);
    return pose;
}

/// Returns that one surface gave in a row, without a gap: what could make a vertical segment.
struct Stretch {
    uint32_t begin, end;
    bool mapped;
};

std::vector<Stretch> stretchesOf(const SimulatedScan& simulated,
                                 const core::VerticalConfig& config) {
    std::vector<Stretch> stretches;
    const auto& points = simulated.scan.points;
    for (const core::ScanColumn& column : simulated.scan.columns) {
        for (uint32_t i = column.begin; i < column.end; ++i) {
            const bool goesOn = i > column.begin &&
                                simulated.truth[i].surface == simulated.truth[i - 1].surface &&
                                double((points[i] - points[i - 1]).norm()) <= config.maxGap;
            if (!goesOn) stretches.push_back({i, i, simulated.truth[i].mapped});
            stretches.back().end = i + 1;
        }
    }
    return stretches;
}

bool makesSegment(const Stretch& stretch, const core::OrganizedScan& scan,
                  const core::VerticalConfig& config) {
    const double height = scan.points[stretch.end - 1].z - scan.points[stretch.begin].z;
    return stretch.end - stretch.begin >= config.minPoints && height >= config.minLength;
}

/// Distance on the ground of a return from the nearest wall of the map, had it no noise.
double offTheMap(const core::LineMap& map, const mrpt::math::TPoint3Df& point) {
    const TPoint2D inMap(2.0 + point.x, 2.5 + point.y);
    const auto nearest = map.nearestWall(inMap, 10, 1);
    return nearest ? nearest->distance : 10;
}

/// How far off a wall of the map a segment may stand and still be taken for it, by a certain pose:
/// eqs. 4, 5 and 7.
double reachOfGate(const core::ReductionConfig& config, double mapSigma) {
    const double tallest = std::max(sensorHeight, roomHeight - sensorHeight);
    return config.matching.sigmaFactor * mapSigma +
           tallest * std::tan(config.groundInterval.maxMountingTilt);
}

struct Counts {
    double wall = 0, wallRemoved = 0;      ///< returns of what the map shows
    double offMap = 0, offMapRemoved = 0;  ///< of what it does not, beyond the reach of the gate
};

Counts countsOf(const SimulatedScan& simulated, const std::vector<PointLabel>& labels,
                const core::LineMap& map, double reach) {
    Counts counts;
    for (size_t i = 0; i < labels.size(); ++i) {
        const bool removed = labels[i] == PointLabel::Mapped;
        if (simulated.truth[i].mapped) {
            ++counts.wall;
            counts.wallRemoved += removed;
        } else if (offTheMap(map, simulated.scan.points[i]) > reach) {
            ++counts.offMap;
            counts.offMapRemoved += removed;
        }
    }
    return counts;
}

}  // namespace

TEST(RoomReduction, withoutNoiseEveryLabelIsExact) {
    const World world = officeRoom();
    const core::LineMap map(mapOf(world));
    const auto simulated = simulate(world, paperScanner(), poseInRoom(), {}, 1);
    core::ReductionConfig config;
    config.matching.method = core::MatchingMethod::Paper;  // looks at segments only
    core::Reducer reducer(map, config);
    const auto& labels = reducer.reduce(simulated.scan).labels;
    size_t onWalls = 0;
    for (const Stretch& stretch : stretchesOf(simulated, config.vertical)) {
        const bool expected =
            stretch.mapped && makesSegment(stretch, simulated.scan, config.vertical);
        if (expected) onWalls += stretch.end - stretch.begin;
        for (uint32_t i = stretch.begin; i < stretch.end; ++i) {
            // A lone return of the floor or of anything else, nearer to a wall than a segment's
            // tolerance, belongs to both.
            const bool both =
                !expected && stretch.end == stretch.begin + 1 &&
                offTheMap(map, simulated.scan.points[i]) <= config.vertical.maxPointToLine;
            EXPECT_TRUE(both || (labels[i] == PointLabel::Mapped) == expected) << "point " << i;
        }
    }
    EXPECT_GT(onWalls, 8000u);  // of 32,761 returns
}

/// As above, but scraps of wall beside a segment go with it.
TEST(RoomReduction, withoutNoiseAlignedRemovesAllSegmentsOfWallsAndNothingElse) {
    const World world = officeRoom();
    const core::LineMap map(mapOf(world));
    const auto simulated = simulate(world, paperScanner(), poseInRoom(), {}, 1);
    const core::ReductionConfig config;
    core::Reducer reducer(map, config);
    const auto& labels = reducer.reduce(simulated.scan).labels;
    for (const Stretch& stretch : stretchesOf(simulated, config.vertical)) {
        const bool segment = makesSegment(stretch, simulated.scan, config.vertical);
        for (uint32_t i = stretch.begin; i < stretch.end; ++i) {
            const bool gone = labels[i] == PointLabel::Mapped;
            if (stretch.mapped && segment) {
                EXPECT_TRUE(gone) << "point " << i;
            }
            const bool alone = stretch.end == stretch.begin + 1;
            const bool atTheWall =
                alone && offTheMap(map, simulated.scan.points[i]) <= config.vertical.maxPointToLine;
            if (!stretch.mapped && !atTheWall) {
                EXPECT_FALSE(gone) << "point " << i;
            }
        }
    }
}

TEST(RoomReduction, withoutNoiseNothingOffTheMapIsRemovedWhateverTheScanner) {
    const World world = officeRoom();
    const core::LineMap map(mapOf(world));
    const core::ReductionConfig config;
    const double reach = reachOfGate(config, map.walls()[0].sigma);
    for (const Scanner& scanner : {paperScanner(), vlp16(), dense()}) {
        const auto simulated = simulate(world, scanner, poseInRoom(), {}, 1);
        core::Reducer reducer(map, config);
        const auto counts = countsOf(simulated, reducer.reduce(simulated.scan).labels, map, reach);
        EXPECT_GT(counts.offMap, 1000);
        EXPECT_EQ(counts.offMapRemoved, 0);
        EXPECT_GT(counts.wallRemoved / counts.wall, 0.99);  // stretches too short to be segments
    }
}

TEST(RoomReduction, noiseCostsNoMoreThanTheEndsOfAStretch) {
    // 1 cm is a fifth of the tolerance, which one return in 1.7 million exceeds. Only where a wall
    // meets floor, ceiling or an edge may noise move a return to the other side: one an end.
    const World world = officeRoom();
    const core::LineMap map(mapOf(world));
    const core::ReductionConfig config;
    const double sigma = 0.01;
    const double reach = reachOfGate(config, map.walls()[0].sigma) + 5 * sigma;
    for (uint64_t seed = 1; seed <= 10; ++seed) {
        const auto simulated =
            simulate(world, paperScanner(), poseInRoom(), {.range = sigma}, seed);
        core::Reducer reducer(map, config);
        const auto& labels = reducer.reduce(simulated.scan).labels;
        double walls = 0, lost = 0, ends = 0;
        for (const Stretch& stretch : stretchesOf(simulated, config.vertical)) {
            if (!stretch.mapped || !makesSegment(stretch, simulated.scan, config.vertical))
                continue;
            ends += 2;
            for (uint32_t i = stretch.begin; i < stretch.end; ++i) {
                ++walls;
                lost += labels[i] != PointLabel::Mapped;
            }
        }
        EXPECT_GT(walls, 8000);
        EXPECT_LE(lost, ends) << "seed " << seed;
        EXPECT_EQ(countsOf(simulated, labels, map, reach).offMapRemoved, 0) << "seed " << seed;
    }
}

TEST(RoomReduction, uncertainPoseRemovesNoLessThanItsGateLetsThrough) {
    // A gate of two sigmas loses 4.6 % by itself; what it allows for besides the position, and the
    // extension, only add to what is found.
    const World world = officeRoom();
    const core::LineMap map(mapOf(world));
    const core::ReductionConfig config;
    core::SensorPose known = poseInRoom();
    const double heading = 0.3 * std::numbers::pi / 180, position = 0.02;
    known.groundCovariance =
        Eigen::Vector3d(position * position, position * position, heading * heading).asDiagonal();
    // The gate widens by the position's sigmas; the estimate errs by five, and turns what is 8 m
    // away.
    const double reach = reachOfGate(config, map.walls()[0].sigma) + 5 * 0.01 +
                         (config.matching.sigmaFactor + 5) * position + 5 * heading * 8;
    GaussianNoise noise(7);
    Counts sum;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        auto simulated = simulate(world, paperScanner(), known, {.range = 0.01}, seed);
        setSensor(simulated.scan, drawEstimate(known, noise));
        core::Reducer reducer(map, config);
        const auto counts = countsOf(simulated, reducer.reduce(simulated.scan).labels, map, reach);
        sum.wall += counts.wall;
        sum.wallRemoved += counts.wallRemoved;
        sum.offMap += counts.offMap;
        sum.offMapRemoved += counts.offMapRemoved;
    }
    EXPECT_GT(sum.wallRemoved / sum.wall, 0.954);
    EXPECT_GT(sum.offMap, 20 * 300);
    EXPECT_EQ(sum.offMapRemoved, 0);
}

}  // namespace offmap::evaluation
