// SPDX-License-Identifier: BSD-3-Clause
#include "ReducedTurns.h"

#include "MadeUpFrame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace offmap::window {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

live::LiveFrame turn(uint64_t number, uint64_t returns, uint64_t removed) {
    live::LiveFrame frame = test::madeUpFrame();
    frame.arrived.number = number;
    frame.reduced.record.counts.returns = returns;
    frame.reduced.record.removedByRay = removed;
    frame.reduced.record.milliseconds = 2.5;
    return frame;
}

TEST(ReducedTurns, eachIsTakenOnceInTheirOrder) {
    ReducedTurns turns;
    turns.add(turn(3, 200, 50));
    turns.add(turn(4, 200, 100));
    const auto taken = turns.take();
    ASSERT_THAT(taken, SizeIs(2));
    EXPECT_EQ(taken[0].number, 3);
    EXPECT_EQ(taken[0].removedShare, 0.25);
    EXPECT_EQ(taken[0].milliseconds, 2.5);
    EXPECT_EQ(taken[1].number, 4);
    EXPECT_EQ(taken[1].removedShare, 0.5);
    EXPECT_THAT(turns.take(), IsEmpty());
}

TEST(ReducedTurns, turnWithoutReturnsHasNothingRemoved) {
    ReducedTurns turns;
    turns.add(turn(0, 0, 0));
    EXPECT_EQ(turns.take().at(0).removedShare, 0);
}

TEST(ReducedTurns, suspectTurnIsToldOf) {
    ReducedTurns turns;
    live::LiveFrame frame = turn(0, 10, 0);
    frame.reduced.record.health.suspect.reset();
    turns.add(frame);
    frame.reduced.record.health.suspect.emplace();
    turns.add(frame);
    const auto taken = turns.take();
    EXPECT_FALSE(taken.at(0).suspect);
    EXPECT_TRUE(taken.at(1).suspect);
}

TEST(ReducedTurns, noneIsLostBetweenTwoThreads) {
    constexpr uint64_t count = 2000;
    ReducedTurns turns;
    const live::LiveFrame frame = turn(0, 10, 5);
    std::jthread writer([&] {
        for (uint64_t i = 0; i < count; ++i) turns.add(frame);
    });
    uint64_t taken = 0;
    while (taken < count) taken += turns.take().size();
    EXPECT_EQ(taken, count);
    writer.join();
    EXPECT_THAT(turns.take(), IsEmpty());
}

}  // namespace
}  // namespace offmap::window
