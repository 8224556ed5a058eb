// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SplitAndMerge.h>

#include <gtest/gtest.h>
#include <mrpt/math/TPose2D.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;
using Ranges = std::vector<std::pair<uint32_t, uint32_t>>;

namespace {

constexpr SplitAndMergeConfig config{0.05, 0.5, 0.3, 4};

std::vector<LinePiece> piecesOf(const std::vector<TPoint2D>& points,
                                const SplitAndMergeConfig& c = config) {
    SplitAndMergeScratch scratch;
    const auto pieces = splitAndMerge(points, c, scratch);
    return {pieces.begin(), pieces.end()};
}

Ranges rangesOf(const std::vector<LinePiece>& pieces) {
    Ranges ranges;
    for (const LinePiece& piece : pieces) ranges.emplace_back(piece.begin, piece.end);
    return ranges;
}

/// Appends points from one to another, the first left out if it is there already.
void addLine(std::vector<TPoint2D>& points, const TPoint2D& from, const TPoint2D& to, int steps) {
    for (int i = points.empty() ? 0 : 1; i <= steps; ++i) {
        points.push_back(from + (to - from) * (double(i) / steps));
    }
}

std::vector<TPoint2D> line(const TPoint2D& from, const TPoint2D& to, int steps) {
    std::vector<TPoint2D> points;
    addLine(points, from, to, steps);
    return points;
}

/// A walk of 60 points in straight stretches, with noise, gaps and standstills.
std::vector<TPoint2D> randomWalk(std::mt19937& random) {
    std::uniform_real_distribution<double> step(0.02, 0.3), angle(-2, 2), chance(0, 1);
    std::normal_distribution<double> noise(0, 0.02);
    std::vector<TPoint2D> points;
    TPoint2D at(2, -1);
    double heading = angle(random);
    for (int i = 0; i < 60; ++i) {
        points.push_back(at + TPoint2D(noise(random), noise(random)));
        if (chance(random) < 0.1) heading += angle(random);
        if (chance(random) < 0.05) at += TPoint2D(1, 1);
        if (chance(random) < 0.05) points.push_back(points.back());
        at += TPoint2D(std::cos(heading), std::sin(heading)) * step(random);
    }
    return points;
}

}  // namespace

TEST(SplitAndMerge, straightLineGivesOnePiece) {
    const auto pieces = piecesOf(line({2, -1}, {2, 2}, 30));
    ASSERT_EQ(rangesOf(pieces), (Ranges{{0, 31}}));
    EXPECT_EQ(pieces[0].line.direction.x, 0);
    EXPECT_EQ(pieces[0].line.point.x, 2);
}

TEST(SplitAndMerge, cornerGivesTwoPieces) {
    auto points = line({0, 0}, {2, 0}, 20);
    addLine(points, {2, 0}, {2, 2}, 20);
    // The corner itself, point 20, lies on both lines; it begins the second.
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 20}, {20, 41}}));
}

TEST(SplitAndMerge, stepIsCutBetweenItsSides) {
    auto points = line({2, 0}, {2, 1}, 10);
    for (const TPoint2D& p : line({2.2, 1.1}, {2.2, 2.1}, 10)) points.push_back(p);
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 11}, {11, 22}}));
}

TEST(SplitAndMerge, gapCuts) {
    auto points = line({2, 0}, {2, 1}, 10);
    for (const TPoint2D& p : line({2, 1.625}, {2, 2.625}, 10)) points.push_back(p);
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 11}, {11, 22}}));
    SplitAndMergeConfig wider = config;
    wider.maxGap = 0.625;
    EXPECT_EQ(rangesOf(piecesOf(points, wider)), (Ranges{{0, 22}}));
}

TEST(SplitAndMerge, strayPointInTheMiddleIsLeftOut) {
    auto points = line({2, 0}, {2, 2}, 20);
    points[10].x += 0.3;
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 10}, {11, 21}}));
}

// 6 cm off, it strays by 5.7 cm from the line through all, and by 4.6 cm only from that through it
// and one side.
TEST(SplitAndMerge, pointThatStraysAloneIsOfNeitherSide) {
    auto points = line({2, 0}, {2, 2}, 20);
    points[10].x += 0.06;
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 10}, {11, 21}}));
}

// What is left before the third point is no piece: nothing is gained by leaving that out, as a line
// serves it and all behind it.
TEST(SplitAndMerge, strayPointNearAnEndIsLeftToTheOthers) {
    auto points = line({2, 0}, {2, 2}, 20);
    points[2].x += 0.06;
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{2, 21}}));
}

TEST(SplitAndMerge, tooFewPointsGiveNone) {
    for (int count = 0; count < 4; ++count) {
        std::vector<TPoint2D> points;
        for (int i = 0; i < count; ++i) points.emplace_back(2, 0.2 * i);
        EXPECT_TRUE(piecesOf(points).empty()) << count << " points";
    }
    EXPECT_EQ(rangesOf(piecesOf({{2, 0}, {2, 0.2}, {2, 0.4}, {2, 0.6}})), (Ranges{{0, 4}}));
}

TEST(SplitAndMerge, onePointMayBeAPieceIfAskedFor) {
    EXPECT_EQ(rangesOf(piecesOf({{2, 0}}, {0.05, 0.5, 0, 1})), (Ranges{{0, 1}}));
    EXPECT_TRUE(piecesOf({}, {0.05, 0.5, 0, 1}).empty());
}

TEST(SplitAndMerge, shorterThanMinLengthGivesNone) {
    EXPECT_TRUE(piecesOf(line({2, 0}, {2, 0.28125}, 10)).empty());
    EXPECT_EQ(piecesOf(line({2, 0}, {2, 0.3125}, 10)).size(), 1u);
}

TEST(SplitAndMerge, duplicatesChangeNoPiece) {
    auto points = line({0, 0}, {2, 0}, 20);
    addLine(points, {2, 0}, {2, 2}, 20);
    std::vector<TPoint2D> doubled;
    for (const TPoint2D& p : points) doubled.insert(doubled.end(), 2, p);
    // Both copies of the corner lie on both lines.
    EXPECT_EQ(rangesOf(piecesOf(doubled)), (Ranges{{0, 40}, {40, 82}}));
    EXPECT_TRUE(piecesOf(std::vector<TPoint2D>(50, {2, 1})).empty());
}

TEST(SplitAndMerge, endsThatCoincideDoNotHideACorner) {
    // There and back again: the chord has no length.
    auto points = line({0, 0}, {2, 0}, 20);
    addLine(points, {2, 0}, {0, 0}, 20);
    for (const LinePiece& piece : piecesOf(points)) EXPECT_LE(piece.end, 41u);
    auto triangle = line({0, 0}, {2, 0}, 20);
    addLine(triangle, {2, 0}, {1, 1.5}, 20);
    addLine(triangle, {1, 1.5}, {0, 0}, 20);
    EXPECT_EQ(piecesOf(triangle).size(), 3u);
}

TEST(SplitAndMerge, lopsidedPointsKeepWithinTheToleranceOfTheirLine) {
    // All within 5 cm of the chord from the first to the last, but not of the line fitted to them.
    std::vector<TPoint2D> points{{0, 0}, {0.1, -0.045}};
    for (int i = 2; i <= 20; ++i) points.emplace_back(0.1 * i, 0.045);
    points.emplace_back(2.1, 0);
    for (const LinePiece& piece : piecesOf(points)) {
        for (uint32_t i = piece.begin; i < piece.end; ++i) {
            EXPECT_LE(piece.line.distance(points[i]), config.maxPointToLine) << "point " << i;
        }
    }
}

TEST(SplitAndMerge, piecesKeepTheirPromisesOnRandomWalks) {
    std::mt19937 random(4);
    size_t total = 0;
    for (int walk = 0; walk < 500; ++walk) {
        const auto points = randomWalk(random);
        uint32_t last = 0;
        for (const LinePiece& piece : piecesOf(points)) {
            ++total;
            EXPECT_GE(piece.begin, last);
            EXPECT_LE(piece.end, points.size());
            EXPECT_GE(piece.end, piece.begin + config.minPoints);
            last = piece.end;
            double low = 0, high = 0;
            for (uint32_t i = piece.begin; i < piece.end; ++i) {
                EXPECT_LE(piece.line.distance(points[i]), config.maxPointToLine);
                low = std::min(low, piece.line.along(points[i]));
                high = std::max(high, piece.line.along(points[i]));
                if (i > piece.begin) {
                    EXPECT_LE((points[i] - points[i - 1]).norm(), config.maxGap);
                }
            }
            EXPECT_GE(high - low, config.minLength);
        }
    }
    EXPECT_GT(total, 500u);  // or the walks would test nothing
}

TEST(SplitAndMerge, rigidMotionChangesNoPiece) {
    std::mt19937 random(5);
    for (int walk = 0; walk < 200; ++walk) {
        const auto points = randomWalk(random);
        const mrpt::math::TPose2D motion(-7, 3, 0.05 * walk);
        std::vector<TPoint2D> moved;
        for (const TPoint2D& p : points) moved.push_back(motion.composePoint(p));
        EXPECT_EQ(rangesOf(piecesOf(moved)), rangesOf(piecesOf(points))) << "walk " << walk;
    }
}

TEST(SplitAndMerge, pointsBesideACornerGoToTheNearerLine) {
    // A wall and the ceiling 3 cm above its last point: within the tolerance of both lines. And the
    // floor, which ends 3 cm before the wall.
    auto points = line({0.97, 0}, {1.97, 0}, 10);
    for (const TPoint2D& p : line({2, 0.1}, {2, 2}, 19)) points.push_back(p);
    for (const TPoint2D& p : line({1.9, 2.03}, {0.9, 2.03}, 10)) points.push_back(p);
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 11}, {11, 31}, {31, 42}}));
}

TEST(SplitAndMerge, reversalChangesNoPiece) {
    auto points = line({0, 0}, {1.97, 0}, 20);
    for (const TPoint2D& p : line({2, 0.08}, {2, 2}, 20)) points.push_back(p);
    for (const TPoint2D& p : line({2.07, 2.07}, {3, 2.7}, 10)) points.push_back(p);
    for (const TPoint2D& p : line({5, 2}, {5, 4}, 20)) points.push_back(p);
    const auto forward = rangesOf(piecesOf(points));
    EXPECT_EQ(forward.size(), 4u);
    std::reverse(points.begin(), points.end());
    Ranges backward;
    for (const auto& [begin, end] : rangesOf(piecesOf(points))) {
        const auto count = static_cast<uint32_t>(points.size());
        backward.insert(backward.begin(), {count - end, count - begin});
    }
    EXPECT_EQ(backward, forward);
}

TEST(SplitAndMerge, scratchCarriesNothingOver) {
    SplitAndMergeScratch scratch;
    const auto tall = line({2, 0}, {2, 3}, 30), low = line({1, 0}, {1, 1}, 10);
    EXPECT_EQ(splitAndMerge(tall, config, scratch).size(), 1u);
    const auto again = splitAndMerge(low, config, scratch);
    ASSERT_EQ(again.size(), 1u);
    EXPECT_EQ(again[0].end, 11u);
    EXPECT_TRUE(splitAndMerge(std::span<const TPoint2D>{}, config, scratch).empty());
}

}  // namespace offmap::core
