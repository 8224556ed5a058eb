// SPDX-License-Identifier: BSD-3-Clause
#include "PlaybackFixture.h"

namespace offmap::window {

namespace {

using test::waitFor;
using testing::ElementsAre;

class PlaybackTest : public test::PlaybackFixture {};

}  // namespace

TEST_F(PlaybackTest, waitsAtTheFirstTurn) {
    open(false);
    ASSERT_TRUE(comes(1));
    EXPECT_FALSE(playback_->playing());
    EXPECT_TRUE(playback_->canPause());
    playback_->step(1);
    ASSERT_TRUE(comesTo(1));
    EXPECT_THAT(seen(), ElementsAre(0, 1)) << "nothing by itself";
}

TEST_F(PlaybackTest, waitsWhereItIsToldToBegin) {
    open(false, 7);
    ASSERT_TRUE(comes(1));
    playback_->step(1);
    ASSERT_TRUE(comesTo(8));
    EXPECT_THAT(seen(), ElementsAre(7, 8));
}

TEST_F(PlaybackTest, playsToTheEndAndThenAnew) {
    open(true);
    ASSERT_TRUE(comes(turns));
    ASSERT_TRUE(ends());
    EXPECT_FALSE(playback_->playing());
    EXPECT_EQ(seen(), fromTo(0, turns)) << "as fast as it can, none is left out";
    playback_->play();
    ASSERT_TRUE(comes(2 * turns));
    ASSERT_TRUE(ends());
    Numbers twice = fromTo(0, turns);
    twice.insert(twice.end(), seen_.begin(), seen_.begin() + turns);
    EXPECT_EQ(seen(), twice);
}

TEST_F(PlaybackTest, playsAnewFromAnEndThatWasSteppedTo) {
    open(false, turns - 1);
    ASSERT_TRUE(comes(1));
    playback_->step(1);
    ASSERT_TRUE(ends());
    playback_->play();
    ASSERT_TRUE(comes(1 + turns));
    ASSERT_TRUE(ends());
    EXPECT_EQ(seen().at(1), 0U);
    EXPECT_EQ(seen().back(), turns - 1);
}

TEST_F(PlaybackTest, pauseStopsAndStepsGoOnFromThere) {
    held_ = true;
    heldFrom_ = 2;
    open(true);
    ASSERT_TRUE(comes(2));
    EXPECT_TRUE(playback_->playing());
    playback_->pause();
    EXPECT_FALSE(playback_->playing());
    held_ = false;
    // One is being reduced, two wait, and one was just about to be handed on.
    ASSERT_TRUE(waitFor([&] { return playback_->figures().turnsWaiting == 0; }));
    const auto stopped = seen().size();
    EXPECT_LE(stopped, 6U);
    playback_->step(1);
    ASSERT_TRUE(comes(stopped + 1));
    EXPECT_EQ(seen(), fromTo(0, seen().size())) << "none twice, none left out";
    EXPECT_LT(seen().size(), turns);
    const uint64_t now = seen().back();
    playback_->step(-1);
    ASSERT_TRUE(comesTo(now - 1));
}

TEST_F(PlaybackTest, stepBackAtTheFirstTurnStaysThere) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->step(-1);
    ASSERT_TRUE(comes(2));
    EXPECT_THAT(seen(), ElementsAre(0, 0));
}

TEST_F(PlaybackTest, stepAtTheEndDoesNothing) {
    open(false, turns - 1);
    ASSERT_TRUE(comes(1));
    playback_->step(1);
    ASSERT_TRUE(ends());
    playback_->step(1);
    playback_->step(-1);
    ASSERT_TRUE(comesTo(turns - 2));
    EXPECT_THAT(seen(), ElementsAre(turns - 1, turns - 2));
}

TEST_F(PlaybackTest, jumpsToATurnAndNoFurtherWhileItIsPaused) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->jumpTo(9);
    ASSERT_TRUE(comes(2));
    playback_->jumpTo(3);
    ASSERT_TRUE(comes(3));
    playback_->step(1);
    ASSERT_TRUE(comes(4));
    EXPECT_THAT(seen(), ElementsAre(0, 9, 3, 4));
}

TEST_F(PlaybackTest, aJumpBehindTheEndShowsNothingAndOneBackWorks) {
    open(false);
    ASSERT_TRUE(comes(1));
    playback_->jumpTo(1000);
    ASSERT_TRUE(ends());
    playback_->jumpTo(2);
    ASSERT_TRUE(comes(2));
    EXPECT_THAT(seen(), ElementsAre(0, 2));
}

TEST_F(PlaybackTest, newParametersReduceTheSameTurnAgain) {
    open(false, 4);
    ASSERT_TRUE(comes(1));
    ASSERT_GT(playback_->latest()->reduced.record.removed(), 0U);
    rawlog::Config config;
    config.reduction.vertical.minLength = 30;  // [m] higher than the room
    playback_->setConfig(config);
    ASSERT_TRUE(waitFor([&] { return latest_ == 2; }));
    EXPECT_EQ(playback_->latest()->reduced.record.removed(), 0U);
    EXPECT_EQ(playback_->latest()->arrived.number, 4U);
    EXPECT_THAT(seen(), ElementsAre(4)) << "it is the same turn, not one more";
    playback_->step(1);
    ASSERT_TRUE(comesTo(5));
    EXPECT_EQ(playback_->latest()->reduced.record.removed(), 0U);
}

TEST_F(PlaybackTest, parametersThatCannotBeAreRefusedAndTheOthersStay) {
    open(false);
    ASSERT_TRUE(comes(1));
    rawlog::Config config;
    config.reduction.vertical.minLength = -1;
    EXPECT_THROW(playback_->setConfig(config), std::invalid_argument);
    playback_->step(1);
    ASSERT_TRUE(comesTo(1));
    EXPECT_GT(playback_->latest()->reduced.record.removed(), 0U);
}

TEST_F(PlaybackTest, endsWhileItPlays) {
    held_ = true;
    heldFrom_ = 3;
    open(true);
    ASSERT_TRUE(comes(3));
    held_ = false;
    playback_.reset();
    const Numbers before = seen();
    EXPECT_LT(before.size(), turns + 1);
    EXPECT_EQ(before, fromTo(0, before.size()));
}

}  // namespace offmap::window
