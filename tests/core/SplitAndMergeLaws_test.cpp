// SPDX-License-Identifier: BSD-3-Clause
#include "PiecesOfPoints.h"

#include <offmap/core/SplitAndMerge.h>

#include <gtest/gtest.h>
#include <mrpt/math/TPose2D.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

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
