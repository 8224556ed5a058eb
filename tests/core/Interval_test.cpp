// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/Interval.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace offmap::core {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// Eighths, which double arithmetic adds without rounding.
double anyEighth() { return *rc::gen::inRange(-80, 80) / 8.0; }

Interval anyInterval() {
    const double a = anyEighth(), b = anyEighth();
    return {std::min(a, b), std::max(a, b)};
}

std::optional<Interval> intersection(const Interval& a, const Interval& b) {
    const double min = std::max(a.min(), b.min()), max = std::min(a.max(), b.max());
    return min <= max ? std::optional(Interval(min, max)) : std::nullopt;
}

void expectLaws(const Interval& a, const Interval& b) {
    const auto common = intersection(a, b);
    EXPECT_EQ(a.intersects(b), common.has_value());
    EXPECT_EQ(a.intersects(b), b.intersects(a));
    EXPECT_EQ(a.contains(b), common == b);
    EXPECT_EQ(a.contains(b), a.contains(b.min()) && a.contains(b.max()));
    EXPECT_EQ(a.contains(b) && b.contains(a), a == b);
}

}  // namespace

TEST(Interval, lawsHoldForEveryPairOfTheTable) {
    const std::vector<Interval> table{{0, 0},    {0, 1},   {1, 1},     {1, 2},
                                      {0, 2},    {0.5, 1}, {-1, 3},    {2, 3},
                                      {-inf, 0}, {1, inf}, {inf, inf}, Interval::everything()};
    for (const Interval& a : table) {
        for (const Interval& b : table) expectLaws(a, b);
    }
}

TEST(Interval, touchingEndsIntersect) {
    EXPECT_TRUE(Interval(0, 1).intersects({1, 2}));
    EXPECT_FALSE(Interval(0, 1).intersects({std::nextafter(1.0, 2.0), 2}));
}

TEST(Interval, onePointContainsItself) {
    const Interval point(2, 2);
    EXPECT_TRUE(point.contains(2.0));
    EXPECT_TRUE(point.contains(point));
    EXPECT_EQ(point.width(), 0);
    EXPECT_EQ(point.centre(), 2);
}

TEST(Interval, wrongOrderOrNanThrows) {
    EXPECT_THROW(Interval(1, 0), std::invalid_argument);
    EXPECT_THROW(Interval(nan, 0), std::invalid_argument);
    EXPECT_THROW(Interval(0, nan), std::invalid_argument);
    EXPECT_THROW(Interval::around(0, -1e-9), std::invalid_argument);
    EXPECT_THROW(Interval::around(nan, 1), std::invalid_argument);
}

TEST(Interval, shrinkingBeyondNothingThrows) {
    EXPECT_EQ(Interval(0, 1).expanded(-0.5), Interval(0.5, 0.5));
    EXPECT_THROW(Interval(0, 1).expanded(-0.625), std::invalid_argument);
}

TEST(Interval, everythingContainsAll) {
    for (const double x : {-inf, -1e300, 0.0, 1e300, inf}) {
        EXPECT_TRUE(Interval::everything().contains(x));
    }
    EXPECT_FALSE(Interval::everything().contains(nan));
}

RC_GTEST_PROP(IntervalLaws, holdForAnyPair, ()) {
    const Interval a = anyInterval(), b = anyInterval();
    const auto common = intersection(a, b);
    RC_ASSERT(a.intersects(b) == common.has_value());
    RC_ASSERT(a.intersects(b) == b.intersects(a));
    RC_ASSERT(a.contains(b) == (common == b));
    RC_ASSERT((a.contains(b) && b.contains(a)) == (a == b));
}

RC_GTEST_PROP(IntervalLaws, expandingIsUndoneByShrinking, ()) {
    const Interval a = anyInterval();
    const double margin = *rc::gen::inRange(0, 80) / 8.0;
    RC_ASSERT(a.expanded(margin).contains(a));
    RC_ASSERT(a.expanded(margin).width() == a.width() + 2 * margin);
    RC_ASSERT(a.expanded(margin).expanded(-margin) == a);
}

RC_GTEST_PROP(IntervalLaws, expandingAnyOfTwoIsTheSame, ()) {
    const Interval a = anyInterval();
    const double x = anyEighth(), reach = *rc::gen::inRange(0, 80) / 8.0;
    RC_ASSERT(a.expanded(reach).contains(x) == a.intersects(Interval::around(x, reach)));
}

}  // namespace offmap::core
