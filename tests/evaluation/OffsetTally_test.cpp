// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/OffsetTally.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace offmap::evaluation {

namespace {

constexpr double gate = 0.35, width = 0.1;  // [m]
constexpr double rounding = 1e-12;

}  // namespace

TEST(OffsetTally, nothingTalliedHasNoWeight) {
    EXPECT_EQ(OffsetTally(gate).densest(width).weight, 0);
}

TEST(OffsetTally, meanAndDeviationAreThoseOfTheWeightedOffsets) {
    OffsetTally tally(gate);
    tally.add(0.05, 1, 10);
    tally.add(0.07, 3, 20);
    const Spread spread = tally.densest(width);
    EXPECT_NEAR(spread.mean(), 0.065, rounding);
    // Variance of two values 0.02 apart with shares 1/4 and 3/4: 3/16 0.02^2.
    EXPECT_NEAR(spread.deviation(), 0.02 * std::sqrt(3.0 / 16), rounding);
    EXPECT_EQ(spread.segments, 2U);
    EXPECT_EQ(spread.returns, 30U);
}

TEST(OffsetTally, whatIsFurtherOffThanTheSurfaceDoesNotCount) {
    OffsetTally tally(gate);
    for (int i = 0; i < 10; ++i) tally.add(0.02, 1, 5);
    for (int i = 0; i < 6; ++i) tally.add(-0.2, 1, 5);
    tally.add(0.3, 2, 5);
    EXPECT_NEAR(tally.densest(width).mean(), 0.02, rounding);
    EXPECT_EQ(tally.densest(width).segments, 10U);
}

TEST(OffsetTally, tallThingsCountMoreThanManyLowOnes) {
    OffsetTally tally(gate);
    tally.add(0.1, 2.5, 40);
    for (int i = 0; i < 4; ++i) tally.add(-0.2, 0.4, 10);
    EXPECT_NEAR(tally.densest(width).mean(), 0.1, rounding);
}

TEST(OffsetTally, ofEqualSurfacesTheOneNearTheWallCounts) {
    OffsetTally tally(gate);
    tally.add(-0.3, 1, 5);
    tally.add(0.1, 1, 5);
    EXPECT_NEAR(tally.densest(width).mean(), 0.1, rounding);
}

TEST(OffsetTally, beyondTheGateAndWithoutWeightNothingIsTallied) {
    OffsetTally tally(gate);
    tally.add(0.36, 1, 5);
    tally.add(-0.36, 1, 5);
    tally.add(std::numeric_limits<double>::quiet_NaN(), 1, 5);
    tally.add(0.1, 0, 5);
    EXPECT_EQ(tally.densest(width).weight, 0);
    tally.add(gate, 1, 5);
    tally.add(gate, 1, 5);
    EXPECT_EQ(tally.densest(width).segments, 2U);
}

}  // namespace offmap::evaluation
