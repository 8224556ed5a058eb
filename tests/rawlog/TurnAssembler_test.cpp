// SPDX-License-Identifier: BSD-3-Clause
#include "../support/SimulatedRobot.h"
#include "../support/SweepMaker.h"

#include <offmap/rawlog/TurnAssembler.h>

#include <gtest/gtest.h>

namespace offmap::rawlog {
namespace {

TEST(TurnAssembler, aCloudIsATurnByItself) {
    test::SimulatedRobot robot;
    const Config config;
    TurnAssembler assembler(config);
    const auto turns = assembler.add(robot.cloud(), 7);
    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].turn.size(), 1U);
    EXPECT_EQ(turns[0].firstEntry, 7U);
    EXPECT_EQ(turns[0].lastEntry, 7U);
    EXPECT_TRUE(assembler.finish().empty());
}

TEST(TurnAssembler, posesAreNoTurns) {
    const test::SimulatedRobot robot;
    const Config config;
    TurnAssembler assembler(config);
    EXPECT_TRUE(assembler.add(robot.localisation(), 0).empty());
}

/// Fans every 2 degrees, ten a second, from `from` to before `to` [deg].
std::vector<PlacedTurn> sweep(TurnAssembler& assembler, int from, int to) {
    std::vector<PlacedTurn> turns;
    for (int degrees = from; degrees < to; degrees += 2) {
        test::FanOptions options;
        options.time = std::chrono::milliseconds(50 * degrees);
        const auto fan = test::fanWithoutReturns(test::fanPose(degrees), options);
        for (PlacedTurn& turn : assembler.add(fan, static_cast<uint64_t>(degrees / 2)))
            turns.push_back(std::move(turn));
    }
    return turns;
}

TEST(TurnAssembler, theFirstTurnOfAnUnknownSweepLosesWhereThatShows) {
    const Config config;
    TurnAssembler assembler(config);
    const auto turns = sweep(assembler, 0, 800);
    ASSERT_EQ(turns.size(), 2U);
    EXPECT_EQ(turns[0].firstEntry, 1U) << "the first fan alone does not tell that it turns";
    EXPECT_EQ(turns[0].turn.size(), 180U);
    EXPECT_EQ(turns[1].firstEntry, 181U);
    const auto last = assembler.finish();
    ASSERT_EQ(last.size(), 1U);
    EXPECT_EQ(last[0].lastEntry, 399U);
}

TEST(TurnAssembler, anExpectedSweepLosesNothing) {
    const Config config;
    TurnAssembler assembler(config);
    assembler.expectSweeps("SWEEP");
    const auto turns = sweep(assembler, 0, 400);
    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].firstEntry, 0U);
}

}  // namespace
}  // namespace offmap::rawlog
