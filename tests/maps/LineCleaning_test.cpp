// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>
#include <offmap/core/WallGeometry.h>
#include <offmap/maps/LineCleaning.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <random>

namespace offmap::maps {

namespace {

using Ends = std::array<double, 4>;
using Walls = std::vector<core::Wall>;

constexpr double minLength = 0.05;  // [m]

core::Wall line(double x1, double y1, double x2, double y2) {
    core::Wall wall;
    wall.line = {{x1, y1}, {x2, y2}};
    return wall;
}

Ends ends(const core::Wall& wall) {
    Ends there{wall.line.point1.x, wall.line.point1.y, wall.line.point2.x, wall.line.point2.y};
    Ends back{there[2], there[3], there[0], there[1]};
    return std::min(there, back);
}

/// As a set: whichever order, whichever way.
std::vector<Ends> asSet(const Walls& walls) {
    std::vector<Ends> all;
    for (const core::Wall& wall : walls) all.push_back(ends(wall));
    std::ranges::sort(all);
    return all;
}

std::vector<Ends> setOf(const Walls& walls) { return asSet(cleaned(walls, minLength).walls); }

/// Lines on a raster of decimetres, some of them a few millimetres off or only centimetres long.
Walls drawn(const std::vector<std::array<uint8_t, 4>>& bytes) {
    Walls walls;
    for (const auto& [x, y, way, slip] : bytes) {
        const double along = 0.1 * (1 + way / 4 % 8), off = 0.001 * (slip % 8);
        const double scale = slip % 16 == 0 ? 0.1 : 1;
        const std::array<std::array<double, 2>, 4> ways{{{1, 0}, {0, 1}, {1, 1}, {1, 0.004}}};
        const auto& [dx, dy] = ways.at(way % 4);
        const double x1 = 0.1 * (x % 16), y1 = 0.1 * (y % 4) + off;
        walls.push_back(line(x1, y1, x1 + scale * along * dx, y1 + scale * along * dy));
    }
    return walls;
}

double distanceToAny(const Walls& walls, const mrpt::math::TPoint2D& place) {
    double least = 1e9;
    for (const core::Wall& wall : walls) least = std::min(least, core::distanceTo(wall, place));
    return least;
}

}  // namespace

TEST(LineCleaning, duplicatesBecomeOne) {
    const auto result = cleaned({line(0, 0, 2, 1), line(2, 1, 0, 0), line(0, 0, 2, 1)}, minLength);
    EXPECT_THAT(asSet(result.walls), testing::ElementsAre(Ends{0, 0, 2, 1}));
    EXPECT_EQ(result.merged, 2U);
    EXPECT_EQ(result.tooShort, 0U);
}

TEST(LineCleaning, overlappingTouchingAndHeldPiecesBecomeOne) {
    EXPECT_THAT(setOf({line(0, 0, 2, 0), line(3, 0.002, 1, 0.002), line(3, 0, 4, 0.001),
                       line(0.5, 0, 0.7, 0.001)}),
                testing::ElementsAre(Ends{0, 0, 4, 0.001}));
}

TEST(LineCleaning, openingIsNeverClosed) {
    // a door of 80 cm, and a crack of 4 mm, just more than the tolerance of 3 mm at sigma 3 cm
    for (const double gap : {0.8, 0.004}) {
        EXPECT_EQ(setOf({line(0, 0, 2, 0), line(2 + gap, 0, 4, 0)}).size(), 2U) << gap;
    }
    const Walls dashes{line(0, 0, 0.1, 0), line(0.2, 0, 0.3, 0), line(0.4, 0, 0.5, 0)};
    EXPECT_EQ(setOf(dashes).size(), 3U);
}

TEST(LineCleaning, bothFacesOfAThinWallStay) {
    EXPECT_EQ(setOf({line(0, 0, 2, 0), line(0, 0.006, 2, 0.006)}).size(), 2U);
}

TEST(LineCleaning, cornersAndCurvesKeepTheirShape) {
    // A circle of 5 m, in chords of 2 cm, then 20 cm: the next bends by 0.2 or 2 degrees.
    for (const size_t chords : {1571U, 157U}) {
        Walls circle;
        for (size_t i = 0; i < chords; ++i) {
            const double a = 2 * M_PI * static_cast<double>(i) / static_cast<double>(chords);
            const double b = 2 * M_PI * static_cast<double>(i + 1) / static_cast<double>(chords);
            circle.push_back(
                line(5 * std::cos(a), 5 * std::sin(a), 5 * std::cos(b), 5 * std::sin(b)));
        }
        EXPECT_EQ(setOf(circle), asSet(circle)) << chords;
    }
}

TEST(LineCleaning, shortPieceStaysIfItJoinsALongerLine) {
    const core::Wall speck = line(5, 5, 5.03, 5), longer = line(0, 0, 1, 0);
    const core::Wall jog = line(1, 0, 1, 0.03);
    const auto result = cleaned({speck, longer, jog}, minLength);
    EXPECT_EQ(asSet(result.walls), asSet({longer, jog}));
    EXPECT_EQ(result.tooShort, 1U);
}

TEST(LineCleaning, shortPiecesStayIfTheyReachFarTogether) {
    const Walls bow{line(0, 0, 0.03, 0.01), line(0.03, 0.01, 0.06, 0)};
    EXPECT_EQ(setOf(bow).size(), 2U);
    const Walls square{line(0, 0, 0.03, 0), line(0.03, 0, 0.03, 0.03), line(0.03, 0.03, 0, 0.03),
                       line(0, 0.03, 0, 0)};
    EXPECT_EQ(setOf(square).size(), 0U) << "3 cm x 3 cm, a diagonal of 4.2 cm";
}

TEST(LineCleaning, wallsOfOtherSigmaOrHeightStayApart) {
    core::Wall counter = line(0, 0, 2, 0), vague = line(0, 0, 2, 0);
    counter.height = {0, 1};
    vague.sigma = 0.1;
    EXPECT_EQ(cleaned({line(0, 0, 2, 0), counter, vague}, minLength).walls.size(), 3U);
}

TEST(LineCleaning, arcDrawnTwiceIsOne) {
    Walls twice = core::wallsAlong({{1, 2}, 3, 0, 3}, {});
    const Walls once = twice;
    for (core::Wall wall : once) {
        std::swap(wall.line.point1, wall.line.point2);
        wall.curvature = -wall.curvature;
        twice.push_back(wall);
    }
    twice.push_back(line(4, 2, 1, 5));  // the chord is another wall
    const auto result = cleaned(twice, minLength);
    EXPECT_EQ(result.walls.size(), once.size() + 1);
    EXPECT_EQ(result.merged, once.size());
}

TEST(LineCleaning, wallsKeepTheirOrder) {
    const Walls walls{line(5, 0, 6, 0), line(0, 0, 1, 0), line(0, 3, 1, 3), line(1, 0, 2, 0)};
    const auto result = cleaned(walls, minLength).walls;
    ASSERT_EQ(result.size(), 3U);
    EXPECT_EQ(ends(result[0]), (Ends{5, 0, 6, 0}));
    EXPECT_EQ(ends(result[1]), (Ends{0, 0, 2, 0}));
    EXPECT_EQ(ends(result[2]), (Ends{0, 3, 1, 3}));
}

RC_GTEST_PROP(LineCleaning, againChangesNothing,
              (const std::vector<std::array<uint8_t, 4>>& bytes)) {
    const auto once = cleaned(drawn(bytes), minLength);
    const auto twice = cleaned(once.walls, minLength);
    RC_ASSERT(asSet(twice.walls) == asSet(once.walls));
    RC_ASSERT(twice.merged + twice.tooShort == 0U);
    RC_ASSERT(once.walls.size() + once.merged + once.tooShort == bytes.size());
}

RC_GTEST_PROP(LineCleaning, orderAndSenseDoNotMatter,
              (const std::vector<std::array<uint8_t, 4>>& bytes, uint32_t seed)) {
    const Walls walls = drawn(bytes);
    Walls shuffled = walls;
    std::mt19937 random(seed);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    for (core::Wall& wall : shuffled) {
        if (random() % 2 == 0) std::swap(wall.line.point1, wall.line.point2);
    }
    RC_ASSERT(setOf(shuffled) == setOf(walls));
}

RC_GTEST_PROP(LineCleaning, noWallIsInventedAndNoneIsLost,
              (const std::vector<std::array<uint8_t, 4>>& bytes)) {
    const Walls before = drawn(bytes), after = cleaned(before, 0).walls;
    // A merger moves a wall by its tolerance and crosses gaps of it; what is merged may be so
    // again.
    const double reach = 3 * mergeTolerance(core::Wall{}.sigma);
    for (const auto& [from, to] : {std::pair{&before, &after}, {&after, &before}}) {
        for (const core::Wall& wall : *from) {
            for (int i = 0; i <= 20; ++i) {
                RC_ASSERT(distanceToAny(*to, core::placeAt(wall, i / 20.0)) <= reach);
            }
        }
    }
}

TEST(LineCleaning, millionLinesTakeSeconds) {
    // Walls of random rooms, every fifth of them drawn twice, one tenth slanted.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0, 3000), length(0.2, 6);
    Walls walls;
    while (walls.size() < 1'000'000) {
        const double x = place(random), y = place(random), l = length(random);
        const auto kind = random() % 10;
        walls.push_back(kind == 0  ? line(x, y, x + l, y + 0.7 * l)
                        : kind < 6 ? line(x, y, x + l, y)
                                   : line(x, y, x, y + l));
        if (random() % 5 == 0) walls.push_back(line(x, y, x + l, y));
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto result = cleaned(walls, minLength);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_GT(result.merged, 50'000U);
    // About 5 s; squared effort would take hours. The rest is for sanitizers and a busy machine.
    EXPECT_LT(seconds.count(), 120);
    RecordProperty("seconds", std::to_string(seconds.count()));
}

}  // namespace offmap::maps
