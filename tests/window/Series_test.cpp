// SPDX-License-Identifier: BSD-3-Clause
#include "Series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace offmap::window {

namespace {

Series seriesOf(std::initializer_list<Series::Sample> samples, size_t capacity = 100) {
    Series series(capacity);
    for (const auto& sample : samples) series.add(sample.place, sample.value);
    return series;
}

}  // namespace

TEST(Series, emptyHasNothing) {
    const Series series(10);
    EXPECT_FALSE(series.at(0));
    EXPECT_FALSE(series.last());
    EXPECT_FALSE(series.greatest(0));
    EXPECT_TRUE(series.columns(0, 10, 5, 1).empty());
}

TEST(Series, columnGivesLeastAndGreatestOfItsSamples) {
    const Series series = seriesOf({{0, 3}, {1, 7}, {2, 5}, {3, 1}});
    const auto columns = series.columns(0, 4, 2, 1);  // two samples each
    ASSERT_EQ(columns.size(), 2U);
    EXPECT_EQ(columns[0].low, 3);
    EXPECT_EQ(columns[0].high, 7);
    EXPECT_EQ(columns[1].low, 1);
    EXPECT_EQ(columns[1].high, 5);
}

TEST(Series, columnsWithoutSamplesAreLeftOut) {
    const auto columns = seriesOf({{0, 1}, {9, 2}}).columns(0, 10, 10, 20);
    ASSERT_EQ(columns.size(), 2U);
    EXPECT_EQ(columns[0].column, 0U);
    EXPECT_EQ(columns[1].column, 9U);
}

TEST(Series, aGapIsNotJoined) {
    const auto columns = seriesOf({{0, 1}, {1, 1}, {5, 1}}).columns(0, 10, 10, 1.5);
    ASSERT_EQ(columns.size(), 3U);
    EXPECT_FALSE(columns[0].joined);
    EXPECT_TRUE(columns[1].joined);
    EXPECT_FALSE(columns[2].joined);
}

TEST(Series, columnsHoldOnlyWhatIsBetweenTheirPlaces) {
    const auto columns = seriesOf({{1, 100}, {2, 1}, {3, 2}, {4, 100}}).columns(2, 4, 1, 1);
    ASSERT_EQ(columns.size(), 1U);
    EXPECT_EQ(columns[0].low, 1);
    EXPECT_EQ(columns[0].high, 2);
}

TEST(Series, samplesInAnyOrderStandByPlace) {
    const Series series = seriesOf({{5, 50}, {1, 10}, {3, 30}});
    EXPECT_EQ(series.last()->place, 5);
    const auto columns = series.columns(0, 6, 6, 10);
    ASSERT_EQ(columns.size(), 3U);
    EXPECT_EQ(columns[1].high, 30);
}

TEST(Series, theSamePlaceAgainReplacesItsValue) {
    const Series series = seriesOf({{1, 10}, {2, 20}, {1, 11}});
    EXPECT_EQ(series.size(), 2U);
    EXPECT_EQ(series.at(1), 11);
}

TEST(Series, beyondItsCapacityTheFirstPlacesAreForgotten) {
    const Series series = seriesOf({{1, 10}, {2, 20}, {3, 30}}, 2);
    EXPECT_EQ(series.size(), 2U);
    EXPECT_FALSE(series.at(1));
    EXPECT_EQ(series.at(3), 30);
}

TEST(Series, forgetBeforeKeepsThePlaceItself) {
    Series series = seriesOf({{1, 10}, {2, 20}, {3, 30}});
    series.forgetBefore(2);
    EXPECT_FALSE(series.at(1));
    EXPECT_EQ(series.at(2), 20);
}

TEST(Series, whatIsNotFiniteIsLeftOut) {
    const Series series = seriesOf({{std::nan(""), 1}, {1, std::nan("")}, {2, HUGE_VAL}});
    EXPECT_EQ(series.size(), 0U);
}

TEST(Series, greatestLooksFromAPlaceOn) {
    const Series series = seriesOf({{1, 100}, {2, 5}, {3, 7}});
    EXPECT_EQ(series.greatest(2), 7);
}

TEST(Series, anAxisWithoutLengthHasNoColumns) {
    const Series series = seriesOf({{1, 1}});
    EXPECT_TRUE(series.columns(1, 1, 10, 1).empty());
    EXPECT_TRUE(series.columns(0, 2, 0, 1).empty());
}

}  // namespace offmap::window
