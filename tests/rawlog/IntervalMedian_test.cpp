// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/IntervalMedian.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

using offmap::rawlog::IntervalMedian;

IntervalMedian seen(const std::vector<double>& times) {
    IntervalMedian median;
    for (const double time : times) median.add(mrpt::Clock::fromDouble(1.7e9 + time));
    return median;
}

/// [s] Stamps count 100 ns, and two of them are rounded.
constexpr double tick = 2e-7;

TEST(IntervalMedian, fewerThanTwoStampsHaveNone) {
    EXPECT_EQ(seen({}).seconds(), std::nullopt);
    EXPECT_EQ(seen({3}).seconds(), std::nullopt);
    EXPECT_EQ(seen({3}).rate(), std::nullopt);
}

TEST(IntervalMedian, evenStampsGiveTheirInterval) {
    EXPECT_NEAR(*seen({0, 0.25, 0.5, 0.75}).seconds(), 0.25, tick);
    EXPECT_NEAR(*seen({0, 0.25, 0.5, 0.75}).rate(), 4, 4 * 4 * tick);
}

TEST(IntervalMedian, longPausesDoNotCount) {
    EXPECT_NEAR(*seen({0, 0.1, 0.2, 3600, 3600.1, 3600.2, 9000}).seconds(), 0.1, tick);
}

TEST(IntervalMedian, isThatOfOddIntervals) {
    // 1, 2, 4, 8, 16 s
    EXPECT_NEAR(*seen({0, 1, 3, 7, 15, 31}).seconds(), 4, tick);
}

TEST(IntervalMedian, stampsThatStandOrRunBackMakeNoInterval) {
    EXPECT_NEAR(*seen({0, 0.5, 0.5, 0.5, 1.0, 0.2, 0.7}).seconds(), 0.5, tick);
    EXPECT_EQ(seen({2, 1, 0}).seconds(), std::nullopt);
}

TEST(IntervalMedian, survivesTheFarthestStamps) {
    IntervalMedian median;
    median.add(mrpt::Clock::time_point::min());
    median.add(mrpt::Clock::time_point::max());
    // 2^64 - 1 ticks of 0.1 us.
    ASSERT_TRUE(median.seconds());
    EXPECT_NEAR(*median.seconds(), 1.8446744e12, 1e5);
}

}  // namespace
