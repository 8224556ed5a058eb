// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Health.h>

#include <gtest/gtest.h>

namespace offmap::core {

namespace {

constexpr uint32_t returnsEach = 5;

/// Segments of five returns each, all of them removed with wall 0, as far from it as said.
ReductionResult matched(uint32_t segments, double behind = 0) {
    ReductionResult result;
    for (uint32_t s = 0; s < segments; ++s) {
        const uint32_t begin = s * returnsEach;
        result.segments.push_back({s, begin, begin + returnsEach, {}, {}, 0, {}});
        SegmentMatch match;
        match.verdict = Verdict::MappedByRay;
        match.reason = KeepReason::None;
        match.wall = 0;
        match.measured = Interval::around(4 + behind, 0.02);
        match.predicted = Interval::around(4, 0.2);
        result.matches.push_back(match);
        result.labels.insert(result.labels.end(), returnsEach, PointLabel::Mapped);
    }
    return result;
}

/// The first segments stand on no wall.
void keep(ReductionResult& result, uint32_t segments, std::optional<uint32_t> wall) {
    for (uint32_t s = 0; s < segments; ++s) {
        result.matches[s].verdict = Verdict::Kept;
        result.matches[s].reason = wall ? KeepReason::InFrontOfWall : KeepReason::NoWallOnRay;
        result.matches[s].wall = wall;
        for (uint32_t i = 0; i < returnsEach; ++i) {
            result.labels[s * returnsEach + i] = PointLabel::Kept;
        }
    }
}

Alignment fitting() {
    Alignment alignment;
    alignment.correction.mean << 0.03, -0.04, -0.02, 0, 0;
    alignment.fittedShare = 0.9;
    alignment.priorChiSquare = 2.5;
    alignment.converged = true;
    return alignment;
}

}  // namespace

TEST(Health, ofAllMatchedIsWhole) {
    const Health health = healthOf(matched(20, 0.01));
    EXPECT_EQ(health.matchedShare, 1);
    EXPECT_NEAR(health.residualBias.value(), 0.01, 1e-12);
    EXPECT_FALSE(health.suspect);
    EXPECT_FALSE(health.fit);
}

TEST(Health, ofNoSegmentTellsNothing) {
    const Health health = healthOf({});
    EXPECT_FALSE(health.matchedShare);
    EXPECT_FALSE(health.residualBias);
    EXPECT_FALSE(health.suspect);
}

TEST(Health, shareIsOfTheReturnsWhereTheMapHasWalls) {
    ReductionResult result = matched(20);
    keep(result, 10, 0);
    EXPECT_NEAR(healthOf(result).matchedShare.value(), 0.5, 1e-12);
    keep(result, 10, std::nullopt);
    EXPECT_EQ(healthOf(result).matchedShare, 1);
    result.labels[10 * returnsEach] = PointLabel::Kept;  // one of 50, of a removed segment
    EXPECT_NEAR(healthOf(result).matchedShare.value(), 0.98, 1e-12);
}

TEST(Health, fewMatchesAreSuspectUnlessThereIsLittleToMatch) {
    ReductionResult result = matched(40);
    keep(result, 28, 0);
    EXPECT_FALSE(healthOf(result).suspect);  // just 30 %
    keep(result, 29, 0);
    EXPECT_EQ(healthOf(result).suspect, Suspicion::FewMatches);
    ReductionResult small = matched(19);
    keep(small, 19, 0);
    EXPECT_EQ(healthOf(small).matchedShare, 0);
    EXPECT_FALSE(healthOf(small).suspect);
}

TEST(Health, wallsAllNearerOrFurtherAreSuspect) {
    EXPECT_FALSE(healthOf(matched(20, 0.10)).suspect);
    EXPECT_EQ(healthOf(matched(20, 0.12)).suspect, Suspicion::Biased);
    EXPECT_EQ(healthOf(matched(20, -0.12)).suspect, Suspicion::Biased);
    EXPECT_FALSE(healthOf(matched(19, 0.12)).suspect);
}

TEST(Health, biasIsRobust) {
    ReductionResult result = matched(21, 0.02);
    for (uint32_t s = 0; s < 10; ++s) result.matches[s].measured = Interval::around(7, 0.02);
    EXPECT_NEAR(healthOf(result).residualBias.value(), 0.02, 1e-12);
}

TEST(Health, poseThatTheScanContradictsIsSuspectThoughAllMatches) {
    ReductionResult result = matched(20);
    result.alignment = fitting();
    const Health good = healthOf(result);
    EXPECT_FALSE(good.suspect);
    ASSERT_TRUE(good.fit);
    EXPECT_NEAR(good.fit->shift, 0.05, 1e-12);
    EXPECT_EQ(good.fit->turn, -0.02);
    EXPECT_EQ(good.fit->fittedShare, 0.9);
    EXPECT_EQ(good.fit->priorChiSquare, 2.5);
    EXPECT_EQ(good.fit->priorInflation, 1);
    result.alignment->priorInflation = 3;
    EXPECT_EQ(healthOf(result).suspect, Suspicion::PoseContradicted);
    result.alignment = fitting();
    result.alignment->priorChiSquare = 17;
    EXPECT_EQ(healthOf(result).suspect, Suspicion::PoseContradicted);
}

TEST(Health, scanKeptWholeTellsNoShare) {
    ReductionResult result = matched(20);
    keep(result, 20, std::nullopt);
    result.alignment = fitting();
    result.notReduced = PoseFault::DoesNotFit;
    EXPECT_EQ(healthOf(result).suspect, Suspicion::DoesNotFit);
    EXPECT_FALSE(healthOf(result).matchedShare);
    EXPECT_TRUE(healthOf(result).fit);
    result.notReduced = PoseFault::TooOld;  // its reason says all
    EXPECT_FALSE(healthOf(result).suspect);
}

}  // namespace offmap::core
