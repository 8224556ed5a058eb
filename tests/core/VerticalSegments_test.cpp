// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ScanBuilder.h"

#include <offmap/core/VerticalSegments.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;
using mrpt::poses::CPose3D;
using test::Beams;
using test::BuiltScan;
using test::Slab;

namespace {

// Coordinates of up to 8 m in single precision are off by half of 2^-20 m; a tilt, over 1 m or
// more, by twice that.
constexpr double rounding = 1e-6;

struct Found {
    LevelledScan levelled;
    std::vector<VerticalSegment> segments;
};

Found segmentsOf(const OrganizedScan& scan, const VerticalConfig& config = {}) {
    Found found;
    level(scan, found.levelled);
    VerticalSegmentFinder(config).find(scan, found.levelled, found.segments);
    return found;
}

/// One column along the sensor's x axis, from (range, z).
OrganizedScan columnOf(const std::vector<TPoint2D>& profile) {
    OrganizedScan scan;
    for (const TPoint2D& p : profile) {
        scan.points.emplace_back(static_cast<float>(p.x), 0.0f, static_cast<float>(p.y));
    }
    scan.columns.resize(1);
    scan.columns[0].end = static_cast<uint32_t>(profile.size());
    return scan;
}

std::vector<TPoint2D> tiltedWall(double range, double tilt) {
    std::vector<TPoint2D> profile;
    for (int i = 0; i <= 20; ++i) profile.emplace_back(range + 0.1 * i * std::tan(tilt), 0.1 * i);
    return profile;
}

/// Whether a segment holds exactly the points of one surface.
bool holdsJust(const VerticalSegment& segment, const BuiltScan& built, int surface) {
    for (uint32_t i = 0; i < built.surface.size(); ++i) {
        const auto& column = built.scan.columns[segment.column];
        if (i < column.begin || i >= column.end) continue;
        const bool inside = i >= segment.begin && i < segment.end;
        if (inside != (built.surface[i] == surface)) return false;
    }
    return true;
}

}  // namespace

TEST(VerticalSegments, depthOverCosineOfElevationIsAWall) {
    std::vector<TPoint2D> profile;
    constexpr double distance = 3;
    for (int degrees = -30; degrees <= 30; ++degrees) {
        const double elevation = degrees * std::numbers::pi / 180;
        const double depth = distance / std::cos(elevation);
        profile.emplace_back(depth * std::cos(elevation), depth * std::sin(elevation));
    }
    const auto [levelled, segments] = segmentsOf(columnOf(profile));
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_EQ(segments[0].begin, 0u);
    EXPECT_EQ(segments[0].end, 61u);
    EXPECT_NEAR(segments[0].tilt(), 0, rounding);
    EXPECT_NEAR(segments[0].bottom.x, distance, rounding);
    EXPECT_NEAR(segments[0].bottom.y, -distance * std::tan(std::numbers::pi / 6), rounding);
    EXPECT_NEAR(segments[0].top.y, +distance * std::tan(std::numbers::pi / 6), rounding);
    EXPECT_NEAR((segments[0].centre - TPoint2D(distance, 0)).norm(), 0, rounding);
}

TEST(VerticalSegments, tiltIsBoundedByEta) {
    VerticalConfig config;
    config.maxTilt = mrpt::DEG2RAD(5.0);
    for (const double degrees : {-5.1, -4.9, 0.0, 4.9, 5.1}) {
        const double tilt = degrees * std::numbers::pi / 180;
        const auto segments = segmentsOf(columnOf(tiltedWall(3, tilt)), config).segments;
        ASSERT_EQ(segments.size(), std::abs(degrees) < 5 ? 1u : 0u) << degrees << " degrees";
        for (const auto& segment : segments) EXPECT_NEAR(segment.tilt(), std::abs(tilt), rounding);
    }
}

TEST(VerticalSegments, floorAndCeilingAreNone) {
    std::vector<TPoint2D> profile;
    for (int i = 0; i < 20; ++i) profile.emplace_back(1 + 0.1 * i, -1);
    EXPECT_TRUE(segmentsOf(columnOf(profile)).segments.empty());
}

TEST(VerticalSegments, topToBottomGivesTheSameAsBottomToTop) {
    auto profile = tiltedWall(3, 0.01);
    const auto up = segmentsOf(columnOf(profile)).segments;
    std::reverse(profile.begin(), profile.end());
    const auto down = segmentsOf(columnOf(profile)).segments;
    ASSERT_EQ(up.size(), 1u);
    ASSERT_EQ(down.size(), 1u);
    EXPECT_NEAR((up[0].bottom - down[0].bottom).norm(), 0, rounding);
    EXPECT_NEAR((up[0].top - down[0].top).norm(), 0, rounding);
    EXPECT_LT(up[0].bottom.y, up[0].top.y);
}

TEST(VerticalSegments, personBeforeWallGivesTwoInOneColumn) {
    const std::vector<Slab> slabs{{{{2.2, -0.3}, {2.2, 0.3}}, 0, 1.7}, {{{4, -3}, {4, 3}}, 0, 4}};
    // Beams a degree apart: the last floor return is at 1 / tan(25 deg) = 2.14 m.
    const test::ScanBuilder world(slabs, CPose3D(0, 0, 1, 0, 0, 0));
    const BuiltScan built = world.build({.columns = 1, .rows = 121, .firstAzimuth = 0});
    const auto segments = segmentsOf(built.scan).segments;
    ASSERT_EQ(segments.size(), 2u);
    EXPECT_TRUE(holdsJust(segments[0], built, 0));
    EXPECT_TRUE(holdsJust(segments[1], built, 1));
    EXPECT_NEAR(segments[0].bottom.x, 2.2, rounding);
    EXPECT_NEAR(segments[1].bottom.x, 4, rounding);
}

TEST(VerticalSegments, tiltedSensorGivesWhatAnUprightOneDoes) {
    auto slabs = test::boxRoom(8, 6);
    slabs.push_back({{{2, -0.3}, {2, 0.3}}, 0, 1.7});
    const Beams beams{.columns = 72};
    const auto upright =
        segmentsOf(test::ScanBuilder(slabs, CPose3D(0.3, 0.2, 1, 0.5, 0, 0)).build(beams).scan);
    const auto tilted = segmentsOf(
        test::ScanBuilder(slabs, CPose3D(0.3, 0.2, 1, 0.5, 0.2, -0.3)).build(beams).scan);
    ASSERT_GE(upright.segments.size(), 72u);
    ASSERT_EQ(tilted.segments.size(), upright.segments.size());
    for (size_t s = 0; s < upright.segments.size(); ++s) {
        const VerticalSegment &a = upright.segments[s], &b = tilted.segments[s];
        EXPECT_EQ(std::tie(a.column, a.begin, a.end), std::tie(b.column, b.begin, b.end));
        EXPECT_NEAR(a.tilt(), b.tilt(), 4 * rounding);
        EXPECT_NEAR((a.bottom - b.bottom).norm(), 0, 2 * rounding);
        EXPECT_NEAR((a.top - b.top).norm(), 0, 2 * rounding);
        EXPECT_NEAR((a.centre - b.centre).norm(), 0, 2 * rounding);
    }
}

TEST(VerticalSegments, columnWithoutPoseIsLevelledByItsMounting) {
    const auto room = test::boxRoom(8, 6);
    auto scan = test::ScanBuilder(room, CPose3D(0, 0, 1, 0, 0.2, 0)).build({.columns = 2}).scan;
    for (ScanColumn& column : scan.columns) {
        column.sensor.reset();
        column.sensorInVehicle = {0, 0, 1, 0, 0.2, 0};
    }
    EXPECT_EQ(segmentsOf(scan).segments.size(), 2u);
    for (ScanColumn& column : scan.columns) column.sensorInVehicle = {};
    EXPECT_TRUE(segmentsOf(scan).segments.empty());
}

TEST(VerticalSegments, emptyAndOnePointColumnsGiveNone) {
    OrganizedScan scan = columnOf(tiltedWall(3, 0));
    const auto points = scan.columns[0].end;
    scan.points.emplace_back(1.0f, 0.0f, 0.0f);
    scan.columns.assign(4, ScanColumn());
    scan.columns[1].end = scan.columns[2].begin = scan.columns[2].end = points;
    scan.columns[3].begin = points;
    scan.columns[3].end = points + 1;
    const auto segments = segmentsOf(scan).segments;
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_EQ(segments[0].column, 1u);
    EXPECT_TRUE(segmentsOf({}).segments.empty());
}

TEST(VerticalSegments, tellWhatTheirOwnPointsSpan) {
    // A floor, a wall with one return 4 cm behind the others, and a ceiling; as many as lanes, and
    // not.
    for (const int points : {5, 8, 21, 40}) {
        std::vector<TPoint2D> profile{{2, -1}, {3, -1}, {4, -1}};
        for (int i = 0; i < points; ++i) {
            profile.emplace_back(i == points / 2 ? 5.0625 : 5.03125, -0.75 + 1.5 * i / points);
        }
        const Found found = segmentsOf(columnOf(profile), {.minPoints = 5});
        ASSERT_EQ(found.segments.size(), 1u) << points;
        const VerticalSegment& segment = found.segments[0];
        EXPECT_EQ(segment.end - segment.begin, static_cast<uint32_t>(points));
        EXPECT_EQ(segment.nearest, 5.03125);
        EXPECT_EQ(segment.furthest, 5.0625);
        EXPECT_EQ(segment.lowest, -0.75);
        EXPECT_NEAR(segment.highest, -0.75 + 1.5 * (points - 1) / points, rounding);
        EXPECT_NEAR(segment.centre.x, 5.03125 + 0.03125 / points, rounding);
    }
}

}  // namespace offmap::core
