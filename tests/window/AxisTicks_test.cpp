// SPDX-License-Identifier: BSD-3-Clause
#include "AxisTicks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace offmap::window {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> labelsOf(const std::vector<AxisTick>& ticks) {
    std::vector<std::string> labels;
    for (const AxisTick& tick : ticks) labels.push_back(tick.label);
    return labels;
}

}  // namespace

TEST(AxisTicks, fiveAtMostFromZeroToAHundred) {
    EXPECT_THAT(labelsOf(axisTicks(0, 100, 5)), ElementsAre("0", "50", "100"));
    EXPECT_THAT(labelsOf(axisTicks(0, 100, 6)), ElementsAre("0", "20", "40", "60", "80", "100"));
}

TEST(AxisTicks, decimalsAreThoseOfTheStep) {
    EXPECT_THAT(labelsOf(axisTicks(0, 1, 3)), ElementsAre("0.0", "0.5", "1.0"));
    EXPECT_THAT(labelsOf(axisTicks(0.30, 0.34, 5)),
                ElementsAre("0.30", "0.31", "0.32", "0.33", "0.34"));
}

TEST(AxisTicks, thousandsAreGrouped) {
    EXPECT_THAT(labelsOf(axisTicks(0, 1'000'000, 3)), ElementsAre("0", "500,000", "1,000,000"));
}

TEST(AxisTicks, negativeValuesReachZeroWithoutAMinus) {
    EXPECT_THAT(labelsOf(axisTicks(-1, 0, 3)), ElementsAre("-1.0", "-0.5", "0.0"));
    EXPECT_THAT(labelsOf(axisTicks(-60, 0, 5)), ElementsAre("-60", "-40", "-20", "0"));
}

TEST(AxisTicks, wholeNumbersHaveNothingBetweenThem) {
    EXPECT_THAT(labelsOf(axisTicks(0, 2, 20, true)), ElementsAre("0", "1", "2"));
}

TEST(AxisTicks, neverMoreThanAskedFor) {
    for (const double high : {0.007, 0.9, 3.0, 99.0, 1234.5, 8e9}) {
        for (size_t most = 1; most < 12; ++most) {
            EXPECT_LE(axisTicks(-0.3 * high, high, most).size(), most) << high << ' ' << most;
        }
    }
}

TEST(AxisTicks, anAxisWithoutLengthHasNone) {
    EXPECT_THAT(axisTicks(3, 3, 5), IsEmpty());
    EXPECT_THAT(axisTicks(3, 2, 5), IsEmpty());
    EXPECT_THAT(axisTicks(0, 1, 0), IsEmpty());
    EXPECT_THAT(axisTicks(0, HUGE_VAL, 5), IsEmpty());
    EXPECT_THAT(axisTicks(std::nan(""), 1, 5), IsEmpty());
}

TEST(AxisTicks, aStepTooSmallForItsPlaceEnds) {
    const double far = 1e15;
    EXPECT_LE(axisTicks(far, std::nextafter(far, 2 * far), 5).size(), 5U);
}

TEST(RoundUp, givesOneTwoOrFive) {
    EXPECT_DOUBLE_EQ(roundUp(1), 1);
    EXPECT_DOUBLE_EQ(roundUp(1.1), 2);
    EXPECT_DOUBLE_EQ(roundUp(0.03), 0.05);
    EXPECT_DOUBLE_EQ(roundUp(5.01), 10);
    EXPECT_DOUBLE_EQ(roundUp(1000), 1000);
}

TEST(RoundDown, givesOneTwoOrFive) {
    EXPECT_DOUBLE_EQ(roundDown(1), 1);
    EXPECT_DOUBLE_EQ(roundDown(1.9), 1);
    EXPECT_DOUBLE_EQ(roundDown(0.049), 0.02);
    EXPECT_DOUBLE_EQ(roundDown(9.99), 5);
    EXPECT_DOUBLE_EQ(roundDown(1000), 1000);
}

TEST(LengthLabel, hasTheUnitThatFits) {
    EXPECT_EQ(lengthLabel(5), "5 m");
    EXPECT_EQ(lengthLabel(0.5), "50 cm");
    EXPECT_EQ(lengthLabel(0.002), "2 mm");
    EXPECT_EQ(lengthLabel(2000), "2 km");
    EXPECT_EQ(lengthLabel(5e6), "5,000 km");
}

}  // namespace offmap::window
