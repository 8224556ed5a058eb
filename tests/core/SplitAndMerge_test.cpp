// SPDX-License-Identifier: BSD-3-Clause
#include "PiecesOfPoints.h"

#include <offmap/core/SplitAndMerge.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

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

TEST(SplitAndMerge, whatLiesFlatterThanIsAskedForIsNoPiece) {
    auto points = line({0.5, 0}, {2, 0}, 20);
    addLine(points, {2, 0}, {2.1, 1}, 20);
    addLine(points, {2.1, 1}, {3, 2}, 20);
    SplitAndMergeConfig steep = config;
    steep.maxSlope = 0.2;
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 21}, {21, 40}, {40, 61}}));
    EXPECT_EQ(rangesOf(piecesOf(points, steep)), (Ranges{{21, 40}}));
    steep.maxSlope = 0.05;
    EXPECT_TRUE(piecesOf(points, steep).empty());
}

// As wide a zigzag as a line serves, where single precision is least exact.
TEST(SplitAndMerge, zigzagFarAwayIsOnePiece) {
    std::vector<float> far, along;
    for (int i = 0; i <= 1000; ++i) {
        far.push_back(i % 2 ? 400.047F : 399.953F);
        along.push_back(0.4F * static_cast<float>(i));
    }
    SplitAndMergeScratch scratch;
    EXPECT_EQ(splitAndMerge(PlanePoints{far, along}, config, scratch).size(), 1U);
    EXPECT_EQ(splitAndMerge(PlanePoints{along, far}, config, scratch).size(), 1U);
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

TEST(SplitAndMerge, pointsBesideACornerGoToTheNearerLine) {
    // A wall and the ceiling 3 cm above its last point: within the tolerance of both lines. And the
    // floor, which ends 3 cm before the wall.
    auto points = line({0.97, 0}, {1.97, 0}, 10);
    for (const TPoint2D& p : line({2, 0.1}, {2, 2}, 19)) points.push_back(p);
    for (const TPoint2D& p : line({1.9, 2.03}, {0.9, 2.03}, 10)) points.push_back(p);
    EXPECT_EQ(rangesOf(piecesOf(points)), (Ranges{{0, 11}, {11, 31}, {31, 42}}));
}

}  // namespace offmap::core
