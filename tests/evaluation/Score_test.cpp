// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Score.h>

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

namespace offmap::evaluation {

namespace {

constexpr bool mapped = true, onSegment = true, removed = true;

void expectCount(const RemovalCount& count, uint64_t points, uint64_t gone) {
    EXPECT_EQ(count.points, points);
    EXPECT_EQ(count.removed, gone);
}

/// A scan with so many unmapped points, so many of which were removed.
Score scanOf(uint64_t points, uint64_t gone) {
    Score score;
    score.unmapped = {points, gone};
    return score;
}

}  // namespace

TEST(Score, everyPointIsCountedWhereItBelongs) {
    const std::vector<ScoredPoint> points{
        {mapped, onSegment, removed, SurfaceKind::Wall, {}},
        {mapped, onSegment, !removed, SurfaceKind::Wall, {}},
        {mapped, !onSegment, removed, SurfaceKind::Wall, {}},
        {!mapped, onSegment, removed, SurfaceKind::Object, 0.05F},
        {!mapped, onSegment, !removed, SurfaceKind::Object, 0.05F},
        {!mapped, !onSegment, !removed, SurfaceKind::Object, 0.2F},
        {!mapped, !onSegment, removed, SurfaceKind::Floor, {}},
    };
    const Score score = scoreOf(points);
    expectCount(score.mappedOnSegments, 2, 1);
    expectCount(score.mapped, 3, 2);
    expectCount(score.unmapped, 4, 2);
    expectCount(score.unmappedByKind[size_t(SurfaceKind::Object)], 3, 1);
    expectCount(score.unmappedByKind[size_t(SurfaceKind::Floor)], 1, 1);
    expectCount(score.unmappedByStandOff.at(5), 2, 1);
    expectCount(score.standingOff(10), 1, 0);
    expectCount(score.standingOff(5, 19), 2, 1);
    // MR = 2/3, UP = 1/2; the root of 1/3 to rounding.
    EXPECT_NEAR(score.geometricMean().value(), 0.57735026918962576, 1e-15);
}

TEST(Score, standOffIsRoundedToCentimetresAndPooledBeyondAMetre) {
    Score score;
    for (const float standOff :
         {0.074F, 0.066F, 1.0F, 7.0F, std::numeric_limits<float>::infinity()}) {
        score.add(ScoredPoint{.standOff = standOff});
    }
    ASSERT_EQ(score.unmappedByStandOff.size(), 2u);
    expectCount(score.unmappedByStandOff.at(7), 2, 0);
    expectCount(score.unmappedByStandOff.at(100), 3, 0);
}

TEST(Score, withoutPointsThereIsNoShare) {
    const Score score;
    EXPECT_FALSE(score.mapped.removedShare());
    EXPECT_FALSE(score.unmapped.keptShare());
    EXPECT_FALSE(score.geometricMean());
    EXPECT_FALSE(percentile({}, 0.5));
    EXPECT_FALSE(PooledScore().unmappedRemoved(0.95));
}

TEST(Score, partsAddUpToTheWhole) {
    const std::vector<ScoredPoint> points{
        {mapped, onSegment, removed, SurfaceKind::Wall, {}},
        {!mapped, onSegment, removed, SurfaceKind::Object, 0.1F},
        {!mapped, !onSegment, !removed, SurfaceKind::Object, 0.1F},
    };
    Score sum = scoreOf(std::span(points).first(1));
    sum.add(scoreOf(std::span(points).subspan(1)));
    expectCount(sum.mapped, 1, 1);
    expectCount(sum.unmapped, 2, 1);
    expectCount(sum.unmappedByStandOff.at(10), 2, 1);
    expectCount(sum.unmappedByKind[size_t(SurfaceKind::Object)], 2, 1);
}

TEST(Score, percentileIsTheNearestRank) {
    std::vector<double> values(20);
    std::iota(values.rbegin(), values.rend(), 1);  // 20 ... 1
    EXPECT_EQ(percentile(values, 0.95), 19);       // 19 of 20 do not exceed it
    EXPECT_EQ(percentile(values, 0.951), 20);
    EXPECT_EQ(percentile(values, 1), 20);
    EXPECT_EQ(percentile(values, 0.001), 1);
}

TEST(PooledScore, poolsByPointsAndSpreadsByScans) {
    PooledScore pooled;
    pooled.add(scanOf(1000, 10));
    pooled.add(scanOf(10, 5));
    PooledScore more;
    more.add(scanOf(0, 0));  // no unmapped points: it has no share
    pooled.add(more);
    expectCount(pooled.total().unmapped, 1010, 15);
    EXPECT_EQ(pooled.scans(), 3u);
    EXPECT_EQ(pooled.unmappedRemoved(0.5), 0.01);
    EXPECT_EQ(pooled.unmappedRemoved(1), 0.5);
    EXPECT_FALSE(pooled.mappedRemoved(1));
}

}  // namespace offmap::evaluation
