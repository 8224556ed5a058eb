// SPDX-License-Identifier: BSD-3-Clause
#include "TurnHistory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace offmap::window {

namespace {

TurnHistory historyOf(uint64_t turns) {
    TurnHistory history;
    history.setTurns(turns);
    return history;
}

}  // namespace

TEST(TurnHistory, aLogShowsAllItsTurns) {
    TurnHistory history = historyOf(1200);
    history.add(30, {0.5, 2, false});
    EXPECT_EQ(history.shownFrom(), 0U);
    EXPECT_EQ(history.shownTo(), 1200U);
    ASSERT_TRUE(history.at(30));
    EXPECT_EQ(history.at(30)->removedShare, 0.5);
    EXPECT_FALSE(history.at(31));
}

TEST(TurnHistory, theTurnAtItsOwnPlaceIsItself) {
    for (const uint64_t turns : {1U, 7U, 1200U}) {
        const TurnHistory history = historyOf(turns);
        for (uint64_t number = 0; number < turns; ++number) {
            EXPECT_EQ(history.turnAt(history.shareOf(number)), number) << turns;
        }
    }
}

TEST(TurnHistory, beyondTheEdgesIsTheFirstOrLastTurn) {
    const TurnHistory history = historyOf(10);
    EXPECT_EQ(history.turnAt(-3), 0U);
    EXPECT_EQ(history.turnAt(1), 9U);
    EXPECT_EQ(history.turnAt(7), 9U);
    EXPECT_EQ(history.shareOf(1000), 0.95);
}

TEST(TurnHistory, stepsEndAtTheFirstAndLastTurn) {
    const TurnHistory history = historyOf(10);
    EXPECT_EQ(history.steppedFrom(4, 1), 5U);
    EXPECT_EQ(history.steppedFrom(4, -10), 0U);
    EXPECT_EQ(history.steppedFrom(4, 10), 9U);
}

TEST(TurnHistory, turnsBeyondTheLogAreLeftOut) {
    TurnHistory history = historyOf(10);
    history.add(10, {0.5, 2, false});
    EXPECT_EQ(history.removedShare().size(), 0U);
}

TEST(TurnHistory, liveShowsTheNewestTurns) {
    TurnHistory history = historyOf(0);
    for (uint64_t i = 0; i < 5000; ++i) history.add(i, {0.5, 2, false});
    EXPECT_EQ(history.shownTo(), 5000U);
    EXPECT_EQ(history.shownFrom(), 2000U);
    EXPECT_FALSE(history.at(1999));
    EXPECT_TRUE(history.at(2000));
}

TEST(TurnHistory, liveBeginsWithItsFirstTurn) {
    TurnHistory history = historyOf(0);
    history.add(70'000, {0.5, 2, false});
    EXPECT_EQ(history.shownFrom(), 70'000U);
    EXPECT_EQ(history.shownTo(), 70'000U + TurnHistory::leastLive);
}

TEST(TurnHistory, liveThatCountsFromTheBeginningAgainIsAnotherRun) {
    TurnHistory history = historyOf(0);
    history.add(70'000, {0.5, 2, false});
    history.add(0, {0.6, 2, false});
    EXPECT_EQ(history.shownFrom(), 0U);
    EXPECT_FALSE(history.at(70'000));
    EXPECT_TRUE(history.at(0));
}

TEST(TurnHistory, aLongLogIsRememberedWithinItsBounds) {
    constexpr uint64_t turns = 3 * TurnHistory::mostRemembered;
    TurnHistory history = historyOf(turns);
    for (uint64_t i = 0; i < turns; ++i) history.add(i, {0.5, 2, i == 4});
    EXPECT_LE(history.removedShare().size(), TurnHistory::mostRemembered);
    // The others that share a place with the suspect turn do not hide it.
    EXPECT_TRUE(history.at(4)->suspect);
    EXPECT_FALSE(history.at(turns - 1)->suspect);
}

TEST(TurnHistory, aTurnReducedAgainIsNoLongerSuspect) {
    TurnHistory history = historyOf(10);
    history.add(4, {0.1, 2, true});
    history.add(4, {0.9, 2, false});
    EXPECT_FALSE(history.at(4)->suspect);
    EXPECT_EQ(history.at(4)->removedShare, 0.9);
}

TEST(TurnHistory, figuresThatAreNoNumbersAreLeftOut) {
    TurnHistory history = historyOf(10);
    history.add(4, {std::nan(""), 2, false});
    history.add(5, {0.5, HUGE_VAL, false});
    EXPECT_FALSE(history.at(4));
    EXPECT_FALSE(history.at(5));
}

}  // namespace offmap::window
