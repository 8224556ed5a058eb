// SPDX-License-Identifier: BSD-3-Clause
#include "PlanPath.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace offmap::window {

namespace {

mrpt::Clock::time_point at(double seconds) { return mrpt::Clock::fromDouble(1e9 + seconds); }

}  // namespace

TEST(PlanPath, placesFollowEachOther) {
    PlanPath path;
    path.add({0, 0}, at(0));
    path.add({1, 0}, at(1));
    ASSERT_EQ(path.places().size(), 2U);
    EXPECT_TRUE(path.places()[0].begins);
    EXPECT_FALSE(path.places()[1].begins);
}

TEST(PlanPath, isBrokenWhereTheTimeGoesBack) {
    PlanPath path;
    path.add({0, 0}, at(5));
    path.add({1, 0}, at(4));
    EXPECT_TRUE(path.places()[1].begins);
}

TEST(PlanPath, isBrokenWhereItLeapsFurtherThanARobotGoes) {
    PlanPath path;
    path.add({0, 0}, at(0));
    path.add({30, 0}, at(1));
    EXPECT_TRUE(path.places()[1].begins);
}

TEST(PlanPath, aRobotThatStandsAddsNothing) {
    PlanPath path;
    for (int i = 0; i < 1000; ++i) path.add({3, 0.0001 * (i % 2)}, at(i));
    EXPECT_EQ(path.places().size(), 1U);
}

TEST(PlanPath, aSlowRobotIsSeenToMove) {
    PlanPath path;
    for (int i = 0; i <= 100; ++i) path.add({0.01 * i, 0}, at(i));
    // 1 m in steps of 5 cm, of which rounding may make 6 cm.
    EXPECT_GE(path.places().size(), 17U);
    EXPECT_LE(path.places().size(), 21U);
}

TEST(PlanPath, staysWithinItsBoundsAndKeepsItsBeginning) {
    PlanPath path;
    for (int i = 0; i < 100'000; ++i) path.add({0.1 * i, 0}, at(i));
    EXPECT_LE(path.places().size(), PlanPath::mostPlaces);
    EXPECT_EQ(path.places().front().place.x, 0);
    // The last step that was left out: at 20,000 places of 10 km, one every 0.5 m at least.
    EXPECT_GT(path.places().back().place.x, 9'990);
}

TEST(PlanPath, ofNothingButLeapsStaysWithinItsBounds) {
    PlanPath path;
    for (int i = 0; i < 50'000; ++i) path.add({i % 2 == 0 ? 0.0 : 100.0, 0}, at(i));
    EXPECT_LE(path.places().size(), PlanPath::mostPlaces);
    EXPECT_TRUE(path.places().front().begins);
}

TEST(PlanPath, whatIsNotFiniteIsLeftOut) {
    PlanPath path;
    path.add({std::nan(""), 0}, at(0));
    path.add({0, HUGE_VAL}, at(0));
    EXPECT_TRUE(path.places().empty());
}

TEST(PlanPath, clearForgetsAll) {
    PlanPath path;
    path.add({0, 0}, at(5));
    path.clear();
    EXPECT_TRUE(path.places().empty());
}

}  // namespace offmap::window
