// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

// What the width of a beam and the darkness of a surface do to returns.

namespace offmap::evaluation {

namespace {

constexpr size_t count = 20000;
/// A statistic may be off by 5 of its own standard deviations: 1 false alarm in 1.7 million.
constexpr double sigmas = 5;

/// A wall at x = 3 and, to the left of the x axis only, another before it.
World edgeBeforeWall(double front) {
    World world;
    world.addMappedPanel({{{3, -100}, {3, 100}}, {-100, 100}});
    world.addObject(Panel{{{front, 0}, {front, 100}}, {-100, 100}});
    return world;
}

/// Many times the same beam.
Scanner beamsAt(double azimuth) { return {std::vector<double>(count, azimuth), {0}, 100, 1}; }

size_t mixedOf(const SimulatedScan& simulated) {
    size_t mixed = 0;
    for (const PointTruth& truth : simulated.truth) mixed += truth.mixed;
    return mixed;
}

/// Of the area of a circle of radius 1, that further than this from its middle on one side.
double capOf(double distance) {
    return (std::acos(distance) - distance * std::sqrt(1 - distance * distance)) / std::numbers::pi;
}

}  // namespace

TEST(MixedPixels, shareIsThatOfTheFootprintBeyondTheEdge) {
    // the axis passes 2 mrad to the right of the edge, the footprint reaches 5 mrad to either side
    const auto simulated =
        simulate(edgeBeforeWall(2.5), beamsAt(-0.002), {}, {.beamWidth = 0.01, .mixing = 0.5}, 1);
    const double expected = 0.5 * capOf(0.4);
    EXPECT_NEAR(static_cast<double>(mixedOf(simulated)) / count, expected,
                sigmas * std::sqrt(expected * (1 - expected) / count));
}

TEST(MixedPixels, lieEvenlyBetweenTheSurfaces) {
    const auto simulated =
        simulate(edgeBeforeWall(2.5), beamsAt(-0.002), {}, {.beamWidth = 0.01}, 1);
    double sum = 0;
    for (size_t i = 0; i < count; ++i) {
        const double range = static_cast<double>(simulated.scan.points[i].norm());
        EXPECT_TRUE(simulated.truth[i].mapped);  // the middle of the beam meets the wall
        // cosines of 7 mrad at most: 3 m * 2.5e-5
        if (!simulated.truth[i].mixed) {
            EXPECT_NEAR(range, 3, 1e-4);
            continue;
        }
        EXPECT_GT(range, 2.5 - 1e-4);
        EXPECT_LT(range, 3 + 1e-4);
        sum += range - 2.75;
    }
    const auto n = static_cast<double>(mixedOf(simulated));
    EXPECT_NEAR(sum / n, 0, sigmas * 0.5 / std::sqrt(12 * n) + 1e-4);
}

TEST(MixedPixels, surfacesFarApartDoNotMix) {
    EXPECT_EQ(mixedOf(simulate(edgeBeforeWall(1.4), beamsAt(0), {}, {.beamWidth = 0.01}, 1)), 0u);
}

TEST(MixedPixels, awayFromEdgesNothingMixes) {
    const Scanner scanner = beamsAt(-0.006);  // the footprint ends 1 mrad before the edge
    EXPECT_EQ(mixedOf(simulate(edgeBeforeWall(2.5), scanner, {}, {.beamWidth = 0.01}, 1)), 0u);
}

TEST(MixedPixels, widthChangesNothingBesides) {
    const core::SensorPose sensor{.sensorInMap = {2, 2.5, 0.6, 0, 0, 0}};
    const ScannerNoise thin{.range = 0.02, .angle = 0.001};
    ScannerNoise wide = thin;
    wide.beamWidth = 0.003;
    const auto first = simulate(officeRoom(), paperScanner(), sensor, thin, 1);
    const auto second = simulate(officeRoom(), paperScanner(), sensor, wide, 1);
    ASSERT_EQ(second.scan.points.size(), first.scan.points.size());
    EXPECT_GT(mixedOf(second), 0u);
    for (size_t i = 0; i < first.truth.size(); ++i) {
        EXPECT_FALSE(first.truth[i].mixed);
        EXPECT_TRUE(second.truth[i].mixed || second.scan.points[i] == first.scan.points[i]);
    }
}

TEST(Intensity, isReflectivityTimesCosineOfIncidence) {
    World world;
    world.setReflectivity(world.addPanel({{{3, -100}, {3, 100}}, {-100, 100}}), 0.8);
    const Scanner scanner{{0, 1}, {0, 0.5}, 1000, 1};
    const auto truth = simulate(world, scanner, {}, {}, 1).truth;
    ASSERT_EQ(truth.size(), 4u);
    EXPECT_FLOAT_EQ(truth[0].intensity, 0.8F);
    EXPECT_FLOAT_EQ(truth[1].intensity, static_cast<float>(0.8 * std::cos(0.5)));
    EXPECT_FLOAT_EQ(truth[2].intensity, static_cast<float>(0.8 * std::cos(1.0)));
    EXPECT_FLOAT_EQ(truth[3].intensity, static_cast<float>(0.8 * std::cos(1.0) * std::cos(0.5)));
}

TEST(Intensity, darknessAddsToTheNoiseOfTheRange) {
    World world;
    world.setReflectivity(world.addPanel({{{3, -100}, {3, 100}}, {-100, 100}}), 0.25);
    const auto scan = simulate(world, beamsAt(0), {}, {.range = 0.03, .dark = 0.05}, 1).scan;
    double squares = 0;
    for (const auto& point : scan.points) {
        const double error = static_cast<double>(point.x) - 3;
        squares += error * error;
    }
    const double expected = std::hypot(0.03, 0.75 * 0.05);
    EXPECT_NEAR(std::sqrt(squares / count) / expected, 1, sigmas / std::sqrt(2.0 * count));
}

TEST(Intensity, reflectivityIsAShare) {
    World world;
    const uint32_t floor = world.addFloor();
    EXPECT_THROW(world.setReflectivity(floor, 1.1), std::invalid_argument);
    EXPECT_THROW(world.setReflectivity(floor, std::nan("")), std::invalid_argument);
    EXPECT_THROW(world.setReflectivity(7, 0.5), std::out_of_range);
}

TEST(MixedPixels, unusableTermsAreRefused) {
    for (const ScannerNoise& noise : {ScannerNoise{.dark = -1}, ScannerNoise{.beamWidth = -0.1},
                                      ScannerNoise{.beamWidth = 4}, ScannerNoise{.mixing = 1.5}}) {
        EXPECT_THROW(simulate(edgeBeforeWall(2), beamsAt(0), {}, noise, 1), std::invalid_argument);
    }
}

}  // namespace offmap::evaluation
