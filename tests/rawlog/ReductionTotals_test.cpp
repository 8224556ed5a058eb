// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ReductionTotals.h>
#include <offmap/rawlog/ReportFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <type_traits>

namespace offmap::rawlog {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TurnRecord turnOf(uint64_t points, uint64_t onSegments, uint64_t removed) {
    TurnRecord turn;
    turn.counts.returns = points;
    turn.onVerticalSegments = onSegments;
    turn.removedByRay = removed;
    turn.keptByReason[static_cast<size_t>(core::KeepReason::BehindWall)] = onSegments - removed;
    turn.columns = 10;
    turn.milliseconds = 1;
    return turn;
}

TEST(DurationHistogram, quantilesAreWithinHalfABin) {
    DurationHistogram histogram;
    for (int i = 1; i <= 1001; ++i) histogram.add(0.01 * i);
    // Bins are 1 % wide, their middle stands for them.
    EXPECT_NEAR(histogram.quantile(0.5).value(), 5.01, 0.005 * 5.01 + 1e-9);
    EXPECT_NEAR(histogram.quantile(0.95).value(), 9.51, 0.005 * 9.51 + 1e-9);
    EXPECT_NEAR(histogram.quantile(0).value(), 0.01, 0.005 * 0.01 + 1e-9);
    EXPECT_NEAR(histogram.quantile(1).value(), 10.01, 0.005 * 10.01 + 1e-9);
}

TEST(DurationHistogram, takesWhateverAClockSays) {
    DurationHistogram histogram;
    EXPECT_EQ(histogram.quantile(0.5), std::nullopt);
    histogram.add(0);
    EXPECT_LE(histogram.quantile(0.5).value(), 1.01e-4);
    for (int i = 0; i < 9; ++i) histogram.add(1e12);
    EXPECT_GT(histogram.quantile(0.5).value(), 1e6);
}

TEST(ReductionTotals, addUp) {
    ReductionTotals totals;
    TurnRecord early = turnOf(100, 50, 40), late = turnOf(10, 5, 0);
    early.time = mrpt::Clock::fromDouble(100);
    late.time = mrpt::Clock::fromDouble(103.5);
    late.notReduced = "pose_too_old";
    late.columnsWithoutPose = 10;
    totals.add(late);
    totals.add(early);
    EXPECT_EQ(totals.scans, 2U);
    EXPECT_EQ(totals.counts.returns, 110U);
    EXPECT_EQ(totals.onVerticalSegments, 55U);
    EXPECT_EQ(totals.removed(), 40U);
    EXPECT_EQ(totals.keptByReason[static_cast<size_t>(core::KeepReason::BehindWall)], 15U);
    EXPECT_EQ(totals.scansNotReduced(), 1U);
    EXPECT_EQ(totals.columnsWithoutPose, 10U);
    EXPECT_NEAR(totals.logSeconds(), 3.5, 1e-6);  // the clock counts 100 ns
}

/// Two scans, of which each figure is another.
ReductionTotals someTotals(uint64_t begin, double time) {
    TurnRecord turn;
    forEachCount(
        [&](const char*, auto& count) {
            count = static_cast<std::remove_reference_t<decltype(count)>>(begin++);
        },
        turn);
    for (uint64_t& count : turn.keptByReason) count = begin++;
    turn.keptByReason[static_cast<size_t>(core::KeepReason::None)] = 0;
    turn.milliseconds = 1;
    turn.health.fit = core::PoseFit{0.001 * static_cast<double>(begin), -0.02, 0.9, 1, 1};
    turn.health.suspect = core::Suspicion::PoseContradicted;
    turn.time = mrpt::Clock::fromDouble(time);
    ReductionTotals totals;
    totals.add(turn);
    turn.time = mrpt::Clock::fromDouble(time + 1.5);
    turn.notReduced = "no_pose";
    totals.add(turn);
    totals.notSupported["HDL-64"] = begin;
    return totals;
}

TEST(ReductionTotals, ofSeveralLogsAreSums) {
    const ReductionTotals a = someTotals(1, 100), b = someTotals(1000, 5000);
    ReductionTotals both;
    both.merge(a);
    both.merge(b);
    EXPECT_EQ(both.scans, 4U);
    EXPECT_EQ(both.scansNotReduced(), 2U);
    EXPECT_EQ(both.observationsNotSupported(),
              a.observationsNotSupported() + b.observationsNotSupported());
    forEachCount([](const char* key, uint64_t sum, uint64_t first,
                    uint64_t second) { EXPECT_EQ(sum, first + second) << key; },
                 both, a, b);
    for (size_t r = 0; r < both.keptByReason.size(); ++r) {
        EXPECT_EQ(both.keptByReason[r], a.keptByReason[r] + b.keptByReason[r]);
    }
    EXPECT_EQ(both.milliseconds.quantile(0.5), a.milliseconds.quantile(0.5));
    EXPECT_NEAR(both.logSeconds(), 3.0, 1e-6);  // not what lies between the logs
}

TEST(HealthTotals, countSuspectsAndNameTheFirst) {
    HealthTotals totals;
    core::Health bad, good;
    bad.suspect = core::Suspicion::Biased;
    for (uint64_t scan = 0; scan < 30; ++scan) totals.add(scan, scan % 2 == 0 ? good : bad, true);
    EXPECT_EQ(totals.suspectScans(), 15U);
    EXPECT_EQ(totals.suspectFor(core::Suspicion::Biased), 15U);
    EXPECT_THAT(totals.firstSuspects, ElementsAre(1, 3, 5, 7, 9, 11, 13, 15, 17, 19));
    HealthTotals both = totals;
    both.merge(totals);
    EXPECT_EQ(both.suspectScans(), 30U);
    EXPECT_THAT(both.firstSuspects, IsEmpty());
    EXPECT_EQ(totals.shiftRms(), std::nullopt);
}

TEST(HealthTotals, correctionIsThatOfScansThatWereReduced) {
    HealthTotals totals;
    core::Health health;
    for (const double shift : {0.03, 0.04, 9.0}) {
        health.fit = core::PoseFit{shift, -10 * shift, 1, 1, 1};
        totals.add(0, health, shift < 1);
    }
    EXPECT_EQ(totals.corrected, 2U);
    EXPECT_NEAR(totals.shiftRms().value(), 0.05 / std::sqrt(2), 1e-12);
    EXPECT_NEAR(totals.turnRms().value(), 0.5 / std::sqrt(2), 1e-12);
}

TEST(ReductionTotals, areReadBackFromAReport) {
    const ReductionTotals totals = someTotals(1, 100);
    ReductionTotals again = totalsFrom(toJson(totals));
    again.milliseconds = DurationHistogram(totals.milliseconds.bins());
    EXPECT_EQ(toJson(again), toJson(totals));
    EXPECT_EQ(again.removed(), totals.removed());
    EXPECT_THROW(DurationHistogram({1, 2, 3}), std::invalid_argument);
}

TEST(ReductionTotals, goodResultGivesNoWarning) {
    ReductionTotals totals;
    totals.add(turnOf(100, 50, 15));  // just 30 %
    EXPECT_THAT(totals.warnings(), IsEmpty());
}

// An honest covariance is contradicted now and then.
TEST(ReductionTotals, warnOfMoreThanAFewContradictions) {
    ReductionTotals totals;
    TurnRecord contradicted = turnOf(100, 50, 40);
    contradicted.health.suspect = core::Suspicion::PoseContradicted;
    totals.add(contradicted);
    for (int i = 0; i < 99; ++i) totals.add(turnOf(100, 50, 40));
    EXPECT_THAT(totals.warnings(), IsEmpty());
    totals.add(contradicted);
    EXPECT_THAT(totals.warnings(), ElementsAre(HasSubstr("2 of 101 scans")));
}

TEST(ReductionTotals, warnsOfWhatSmells) {
    const auto warningOf = [](const TurnRecord& turn) {
        ReductionTotals totals;
        totals.add(turn);
        return totals.warnings();
    };
    EXPECT_THAT(warningOf(turnOf(100, 50, 14)), ElementsAre(HasSubstr("only 28.0 %")));
    EXPECT_THAT(warningOf(turnOf(100, 50, 0)), ElementsAre(HasSubstr("nothing was removed")));
    EXPECT_THAT(warningOf(turnOf(100, 0, 0)), ElementsAre(HasSubstr("no vertical segment")));

    TurnRecord contradicted = turnOf(100, 50, 40);
    contradicted.health.suspect = core::Suspicion::PoseContradicted;
    EXPECT_THAT(warningOf(contradicted),
                ElementsAre(AllOf(HasSubstr("--pose-sigma"), HasSubstr("(scan 0)"))));
    TurnRecord biased = turnOf(100, 50, 40);
    biased.health.suspect = core::Suspicion::Biased;
    EXPECT_THAT(warningOf(biased), ElementsAre(HasSubstr("against the map (scan 0)")));
    TurnRecord lost = turnOf(100, 50, 0);
    lost.notReduced = "pose_does_not_fit";
    lost.health.suspect = core::Suspicion::DoesNotFit;
    EXPECT_THAT(warningOf(lost), ElementsAre(AllOf(HasSubstr("1 of 1 scans show what fits no"),
                                                   HasSubstr("--map-origin")),
                                             HasSubstr("no scan could")));

    TurnRecord offMap = turnOf(100, 50, 0);
    offMap.notReduced = "no_wall_in_range";
    EXPECT_THAT(warningOf(offMap),
                ElementsAre(HasSubstr("--map-origin"), HasSubstr("no scan could")));

    // Of 40 points whose columns have a pose, 14 were removed: that is not what smells.
    TurnRecord partly = turnOf(100, 50, 14);
    partly.columnsWithoutPose = 3;
    partly.keptByReason[static_cast<size_t>(core::KeepReason::BehindWall)] -= 10;
    partly.keptByReason[static_cast<size_t>(core::KeepReason::NoPose)] = 10;
    EXPECT_THAT(warningOf(partly), ElementsAre(HasSubstr("3 of 10 columns")));

    ReductionTotals unsupported;
    unsupported.notSupported["HDL-64"] = 3;
    EXPECT_THAT(unsupported.warnings(), ElementsAre(HasSubstr("3 observations")));
    EXPECT_THAT(ReductionTotals().warnings(), ElementsAre(HasSubstr("holds no 3D scan")));
    EXPECT_THAT(warningOf(turnOf(0, 0, 0)), ElementsAre(HasSubstr("no return at all")));
}

}  // namespace
}  // namespace offmap::rawlog
