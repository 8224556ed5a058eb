// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Scanner.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace offmap::evaluation {

namespace {

void expectOneClockwiseTurn(const Scanner& scanner) {
    const auto& azimuths = scanner.azimuths;
    EXPECT_DOUBLE_EQ(azimuths.front(), std::numbers::pi);
    EXPECT_GT(azimuths.back(), -std::numbers::pi);
    EXPECT_TRUE(std::ranges::is_sorted(azimuths, std::greater{}));
    EXPECT_TRUE(std::ranges::is_sorted(scanner.elevations));
    // the step over the end is as wide as the others
    const double step = azimuths[0] - azimuths[1];
    EXPECT_NEAR(azimuths.back() - step, -std::numbers::pi, 1e-12);
}

}  // namespace

TEST(Scanner, paperHasItsNumberOfBeams) {
    const Scanner scanner = paperScanner();
    EXPECT_EQ(scanner.azimuths.size() * scanner.elevations.size(), 32761u);
    EXPECT_DOUBLE_EQ(scanner.elevations.front(), -std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(scanner.elevations.back(), std::numbers::pi / 2);
    expectOneClockwiseTurn(scanner);
}

TEST(Scanner, vlp16HasRingsTwoDegreesApart) {
    const Scanner scanner = vlp16();
    EXPECT_EQ(scanner.azimuths.size(), 1800u);
    ASSERT_EQ(scanner.elevations.size(), 16u);
    for (size_t ring = 0; ring < 16; ++ring) {
        EXPECT_NEAR(scanner.elevations[ring], mrpt::DEG2RAD(-15 + 2.0 * double(ring)), 1e-15);
    }
    expectOneClockwiseTurn(scanner);
}

TEST(Scanner, denseHas128RingsAnd2048Columns) {
    const Scanner scanner = dense();
    EXPECT_EQ(scanner.azimuths.size(), 2048u);
    EXPECT_EQ(scanner.elevations.size(), 128u);
    expectOneClockwiseTurn(scanner);
}

TEST(Scanner, vlp16FiresRingAfterRing) {
    const Scanner scanner = vlp16Firings();
    expectOneClockwiseTurn(scanner);
    EXPECT_NEAR(scanner.turnDuration, 75 * 1327.104e-6, 1e-12);  // packets, each of 12 blocks
    const double step = mrpt::DEG2RAD(0.2) * 2.304 / 55.296;     // of a laser, clockwise
    EXPECT_NEAR(beamAngles(scanner, 0, 0).azimuth, std::numbers::pi, 1e-15);
    EXPECT_NEAR(beamAngles(scanner, 0, 8).azimuth, std::numbers::pi - step, 1e-15);
    EXPECT_NEAR(beamAngles(scanner, 0, 1).azimuth, std::numbers::pi - 2 * step, 1e-15);
    EXPECT_NEAR(beamAngles(scanner, 0, 15).azimuth, std::numbers::pi - 15 * step, 1e-15);
}

TEST(Scanner, depthCameraSeesARowOfPixelsAsAStraightLine) {
    const Scanner camera = depthCamera();
    ASSERT_EQ(camera.azimuths.size(), 320u);
    ASSERT_EQ(camera.elevations.size(), 240u);
    EXPECT_GT(camera.azimuths.front(), 0) << "the first column is the left one";
    const double focalLength = 160 / std::tan(mrpt::DEG2RAD(30.0));
    for (const size_t column : {0u, 100u, 319u}) {
        const auto [azimuth, elevation] = beamAngles(camera, column, 200);
        // on a plane at x = 1 the row stands (200 - 119.5) / f above the middle
        const double z = std::tan(elevation) / std::cos(azimuth);
        EXPECT_NEAR(z, 80.5 / focalLength, 1e-12);
        EXPECT_NEAR(std::tan(azimuth), (159.5 - double(column)) / focalLength, 1e-12);
    }
}

}  // namespace offmap::evaluation
