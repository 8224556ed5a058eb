// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentWorld.h"

#include <offmap/core/HorizontalExtension.h>

#include <gtest/gtest.h>

#include <cmath>

namespace offmap::core {

namespace {

constexpr double wallAt = 2;  // [m] y of a wall along x
constexpr auto ray = Verdict::MappedByRay, extension = Verdict::MappedByExtension,
               kept = Verdict::Kept;

ReductionConfig testConfig() {
    ReductionConfig config;
    config.matching.sigmaFactor = 2;
    config.extension = {
        .maxPointToLine = 0.05, .minLength = 0.3, .minSegments = 3, .maxColumnGap = 2};
    return config;
}

void extendIn(test::SegmentWorld& world, const std::vector<Wall>& walls,
              const ReductionConfig& config = testConfig()) {
    const LineMap map(walls);
    SegmentsByColumn byColumn;
    byColumn.build(world.segments, world.viewpoints);
    ExtensionScratch scratch;
    extendAlongWalls(ColumnRing(world.scan), world.segments, byColumn, world.viewpoints, map,
                     config, scratch, world.matches);
}

/// Columns a degree apart see the wall in front of them; the ray match succeeded in some of them.
/// Column 270 looks along +y, columns 200 to 340 see the wall.
struct AlongTheWall : test::SegmentWorld {
    static constexpr uint32_t first = 200, last = 340;

    AlongTheWall(uint32_t firstMatched, uint32_t lastMatched) : SegmentWorld(360) {
        for (uint32_t c = first; c <= last; ++c) {
            const bool matched = c >= firstMatched && c <= lastMatched;
            add(c, rangeToLine(c, wallAt), matched ? ray : kept);
        }
    }
    Verdict verdictOf(uint32_t column) const { return matches[column - first].verdict; }
};

const std::vector<Wall> longWall{{{{-20, wallAt}, {20, wallAt}}, 0.02}};

}  // namespace

TEST(HorizontalExtension, wallIsFollowedInBothDirectionsOfRotation) {
    AlongTheWall world(260, 280);
    extendIn(world, longWall);
    for (uint32_t c = world.first; c <= world.last; ++c) {
        EXPECT_EQ(world.verdictOf(c), c >= 260 && c <= 280 ? ray : extension) << "column " << c;
    }
    const SegmentMatch& followed = world.matches.front();
    EXPECT_EQ(followed.reason, KeepReason::None);
    EXPECT_EQ(followed.wall, 0u);
}

TEST(HorizontalExtension, wallIsFollowedAcrossTheEndOfTheTurn) {
    // Behind the sensor, where the turn begins and ends: the wall x = -2.
    for (const bool matchedBefore : {true, false}) {
        test::SegmentWorld world(360);
        const auto range = [&](uint32_t c) { return -2 / world.directionOf(c).x; };
        for (uint32_t c = 0; c < 60; ++c) {
            world.add(c, range(c), !matchedBefore && c > 20 && c < 40 ? ray : kept);
        }
        for (uint32_t c = 300; c < 360; ++c) {
            world.add(c, range(c), matchedBefore && c > 320 && c < 340 ? ray : kept);
        }
        extendIn(world, {{{{-2, -20}, {-2, 20}}, 0.02}});
        for (const SegmentMatch& match : world.matches) EXPECT_TRUE(match.mapped());
    }
}

TEST(HorizontalExtension, chainAcrossTheEndOfTheTurnIsOne) {
    // Two matched segments on either side of the end of the turn; a line needs three, so it is
    // found only across it.
    test::SegmentWorld world(360);
    const auto range = [&](uint32_t c) { return -20 / world.directionOf(c).x; };
    for (const uint32_t c : {0u, 1u, 2u}) world.add(c, range(c), c < 2 ? ray : kept);
    for (const uint32_t c : {357u, 358u, 359u}) world.add(c, range(c), c > 357 ? ray : kept);
    extendIn(world, {{{{-20, -20}, {-20, 20}}, 0.02}});
    for (const SegmentMatch& match : world.matches) EXPECT_TRUE(match.mapped());
}

TEST(HorizontalExtension, lineShorterThanItsMinimumIsNotExtended) {
    // Near column 270, a degree is 3.5 cm of the wall: 9 columns span 28 cm, 10 span 31 cm.
    for (const uint32_t columns : {9u, 10u}) {
        AlongTheWall world(266, 265 + columns);
        extendIn(world, longWall);
        EXPECT_EQ(world.verdictOf(300), columns == 10 ? extension : kept) << columns << " columns";
    }
}

TEST(HorizontalExtension, fewerSegmentsThanTheMinimumAreNotExtended) {
    for (const uint32_t segments : {2u, 3u}) {
        AlongTheWall world(205, 204 + segments);  // grazing: 19 cm per degree
        extendIn(world, longWall);
        EXPECT_EQ(world.verdictOf(204), segments == 3 ? extension : kept);
    }
}

TEST(HorizontalExtension, blockedStretchIsCrossedUpToTheColumnGap) {
    for (const uint32_t blocked : {1u, 2u, 3u}) {
        AlongTheWall world(260, 280);
        for (uint32_t c = 300; c < 300 + blocked; ++c) {  // someone stands 50 cm before the wall
            world.segments[c - world.first].centre =
                world.directionOf(c) * (world.rangeToLine(c, wallAt) - 0.5);
        }
        extendIn(world, longWall);
        EXPECT_EQ(world.verdictOf(299), extension);
        EXPECT_EQ(world.verdictOf(300), kept);
        EXPECT_EQ(world.verdictOf(300 + blocked), blocked <= 2 ? extension : kept)
            << blocked << " columns";
    }
}

TEST(HorizontalExtension, columnsWithoutPoseAreLeftAlone) {
    AlongTheWall world(260, 280);
    for (uint32_t c = 290; c < 292; ++c) {
        world.viewpoints[c].reset();
        world.matches[c - world.first] = SegmentMatch();  // Kept, NoPose
    }
    extendIn(world, longWall);
    EXPECT_EQ(world.verdictOf(290), kept);
    EXPECT_EQ(world.matches[290 - world.first].reason, KeepReason::NoPose);
    EXPECT_EQ(world.verdictOf(292), extension);
}

TEST(HorizontalExtension, segmentOffTheLineIsKept) {
    AlongTheWall world(260, 280);
    const auto shift = [&](uint32_t c, double dy) {
        world.segments[c - world.first].centre.y += dy;
    };
    shift(290, -0.045);
    shift(250, -0.055);
    extendIn(world, longWall);
    EXPECT_EQ(world.verdictOf(290), extension);
    EXPECT_EQ(world.verdictOf(250), kept);
    EXPECT_EQ(world.verdictOf(249), extension);
}

TEST(HorizontalExtension, mapConsentEndsWithTheWall) {
    // The map's wall ends at x = 2, at column 225; a box stands in line with it.
    const std::vector<Wall> wall{{{{-20, wallAt}, {2, wallAt}}, 0.02}};
    for (const bool consent : {true, false}) {
        AlongTheWall world(260, 280);
        ReductionConfig config = testConfig();
        config.extension.mapConsent = consent;
        extendIn(world, wall, config);
        for (uint32_t c = world.first; c <= world.last; ++c) {
            const auto& centre = world.segments[c - world.first].centre;
            const bool beyond = centre.x > 2 + config.extension.maxPointToLine;
            EXPECT_EQ(world.matches[c - world.first].mapped(), !beyond || !consent)
                << "column " << c << ", consent " << consent;
        }
    }
}

TEST(HorizontalExtension, mapConsentAllowsForTheHeading) {
    // Where the two parts meet, at 2.2 m, a heading known to 1 degree leaves 2 x 4 cm open.
    const std::vector<Wall> shifted{{{{-1, wallAt}, {1, wallAt}}, 0.02},
                                    {{{1, wallAt + 0.1}, {20, wallAt + 0.1}}, 0.02}};
    for (const double sigmaHeading : {0.0, 0.0175}) {
        AlongTheWall world(260, 280);
        for (auto& viewpoint : world.viewpoints) viewpoint->sigmaHeading = sigmaHeading;
        extendIn(world, shifted);
        // Column 210 sees the wall at x = 3.5 m.
        EXPECT_EQ(world.verdictOf(210), sigmaHeading > 0 ? extension : kept);
    }
}

TEST(HorizontalExtension, everySegmentOfAColumnIsLookedAt) {
    test::SegmentWorld world(360);
    for (uint32_t c = 250; c <= 290; ++c) {
        world.add(c, world.rangeToLine(c, 1), kept);  // a person all along, 1 m before the wall
        world.add(c, world.rangeToLine(c, wallAt), c < 270 ? ray : kept);
    }
    extendIn(world, longWall);
    for (uint32_t s = 0; s < world.segments.size(); ++s) {
        EXPECT_EQ(world.matches[s].mapped(), s % 2 == 1);
    }
}

TEST(HorizontalExtension, nothingMatchedIsNothingExtended) {
    AlongTheWall world(1, 0);
    extendIn(world, longWall);
    for (const SegmentMatch& match : world.matches) EXPECT_EQ(match.verdict, kept);
    test::SegmentWorld empty(360);
    EXPECT_NO_THROW(extendIn(empty, {}));
}

}  // namespace offmap::core
