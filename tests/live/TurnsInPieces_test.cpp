// SPDX-License-Identifier: BSD-3-Clause
#include "TurnsInPiecesFixture.h"

#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <mutex>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;
using test::columnsOfPacket;
using test::lookupsOfTurn;
using test::officeSetup;
using test::pieceOf;
using test::pieceSize;
using test::PiecewiseSource;
using Scan = test::VelodyneObservation;

TEST_F(TurnsInPieces, areTakenInBeforeTheyAreComplete) {
    auto source = std::make_unique<PiecewiseSource>(3);
    awaitAll(*source, *poses_);
    const auto frames = framesOf(std::move(source));
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(poses_->lookups(), 3 * lookupsOfTurn) << "no column is taken in twice";
    for (const LiveFramePtr& frame : frames) expectAsWhole(*frame, setup_);
}

TEST_F(TurnsInPieces, fromOneThatIsMissingOnTheRestWaits) {
    auto source = std::make_unique<PiecewiseSource>(1);
    source->handOverPieces = [](PiecewiseSource& from, uint64_t turn) {
        from.give(pieceOf(*from.scan(turn), turn, 0));
        from.handOverFrom(turn, 2 * pieceSize);
    };
    size_t before = 0;
    source->beforeTurn = [&](uint64_t) {
        EXPECT_TRUE(poses_->waitFor(pieceSize * columnsOfPacket));
        std::this_thread::sleep_for(20ms);  // in which the others would be taken in
        before = poses_->lookups();
    };
    const auto frames = framesOf(std::move(source));
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(before, pieceSize * columnsOfPacket);
    EXPECT_EQ(poses_->lookups(), lookupsOfTurn) << "of the first, no column is taken in twice";
    expectAsWhole(*frames.front(), setup_);
}

TEST_F(TurnsInPieces, ofTwoTurnsAreNotMixed) {
    auto source = std::make_unique<PiecewiseSource>(1);
    source->handOverPieces = [](PiecewiseSource& from, uint64_t turn) {
        from.give(pieceOf(*from.scan(turn), turn, 0));
        from.give(pieceOf(*from.scan(turn), turn + 1, pieceSize));
    };
    source->beforeTurn = [&](uint64_t) {
        EXPECT_TRUE(poses_->waitFor(pieceSize * columnsOfPacket));
        std::this_thread::sleep_for(20ms);  // in which the other would be taken in
        EXPECT_EQ(poses_->lookups(), pieceSize * columnsOfPacket);
    };
    const auto frames = framesOf(std::move(source));
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(poses_->lookups(), lookupsOfTurn);
    expectAsWhole(*frames.front(), setup_);
}

TEST_F(TurnsInPieces, whichTheTurnDoesNotBeginWithAreOfNoUse) {
    const std::function<void(Scan&)> others[] = {
        [](Scan& scan) { test::setReturn(scan.scan_packets[0], 3, 7, 700, 1); },
        [](Scan& scan) { scan.timestamp += 1us; }, [](Scan& scan) { scan.sensorLabel = "OTHER"; }};
    for (const auto& makeOther : others) {
        countLookups(officeSetup().poses);
        auto source = std::make_unique<PiecewiseSource>(1);
        source->handOverPieces = [&](PiecewiseSource& from, uint64_t turn) {
            auto other = std::make_shared<Scan>(*from.scan(turn));
            makeOther(*other);
            from.give(pieceOf(*other, turn, 0));
        };
        source->beforeTurn = [&](uint64_t) {
            EXPECT_TRUE(poses_->waitFor(pieceSize * columnsOfPacket));
        };
        const auto frames = framesOf(std::move(source));
        ASSERT_EQ(frames.size(), 1U);
        EXPECT_EQ(poses_->lookups(), pieceSize * columnsOfPacket + lookupsOfTurn);
        expectAsWhole(*frames.front(), setup_);
    }
}

// Parameters that leave the poses as they are, so that only the new ones tell that all was changed.
TEST_F(TurnsInPieces, areTakenInAnewIfTheSetupChangesMeanwhile) {
    LiveReduction* running = nullptr;
    std::mutex built;
    std::unique_lock building(built);
    LiveSetup tuned;
    auto source = std::make_unique<PiecewiseSource>(2);
    awaitAll(*source, *poses_);
    source->beforeTurn = [&, taken = source->beforeTurn](uint64_t turn) {
        const std::lock_guard wait(built);
        taken(turn);
        if (turn == 1) running->change(tuned);
    };
    std::vector<LiveFramePtr> frames;
    LiveReduction reduction(std::move(source), setup_, {.onFrame = [&](const LiveFramePtr& frame) {
                                frames.push_back(frame);
                            }});
    running = &reduction;
    tuned = setup_;
    tuned.config.reduction.vertical.minLength = 1.5;  // [m]
    building.unlock();
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    ASSERT_EQ(frames.size(), 2U);
    expectAsWhole(*frames[0], setup_);
    expectAsWhole(*frames[1], tuned);
    EXPECT_NE(frames[0]->reduced.record.onVerticalSegments,
              frames[1]->reduced.record.onVerticalSegments);
}

TEST_F(TurnsInPieces, pushNoTurnOutWhereReducingIsTooSlow) {
    constexpr size_t turns = 8;
    LiveReduction* running = nullptr;
    std::mutex built;
    std::unique_lock building(built);
    std::vector<LiveFramePtr> frames;
    const auto onFrame = [&](const LiveFramePtr& frame) {
        const std::lock_guard wait(built);
        while (running->figures().source.received < turns) std::this_thread::sleep_for(1ms);
        std::this_thread::sleep_for(5ms);  // until the last has come, too
        EXPECT_LE(running->figures().turnsWaiting, 2U);
        frames.push_back(frame);
    };
    auto source = std::make_unique<PiecewiseSource>(turns);
    source->waitsForReader = false;
    LiveReduction reduction(std::move(source), setup_, {.waiting = 2, .onFrame = onFrame});
    running = &reduction;
    building.unlock();
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    const LiveFigures figures = reduction.figures();
    EXPECT_EQ(figures.totals.scans + figures.turnsDropped, turns);
    EXPECT_GE(frames.size(), 2U) << "those that wait";
    EXPECT_EQ(frames.back()->arrived.number, turns - 1);
    for (const LiveFramePtr& frame : frames) expectAsWhole(*frame, setup_);
}

// The first turn is held; the pieces of the second wait, those of the third are passed over, as the
// second turn waits. Of both, each column is taken in once, with the turn.
TEST_F(TurnsInPieces, areNotTakenInByWhomTurnsWaitFor) {
    std::promise<void> behind;
    auto source = std::make_unique<PiecewiseSource>(3);
    source->waitsForReader = false;
    source->beforePieces = [&](uint64_t turn) {
        EXPECT_TRUE(turn != 1 || poses_->waitFor(lookupsOfTurn));
    };
    source->beforeTurn = [&](uint64_t turn) {
        if (turn < 2) return;
        behind.set_value();
        EXPECT_TRUE(poses_->waitFor(2 * lookupsOfTurn));
    };
    LiveReduction reduction(std::move(source), setup_, {.onFrame = [&](const LiveFramePtr& frame) {
                                if (frame->arrived.number == 0) behind.get_future().wait();
                            }});
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    EXPECT_EQ(reduction.figures().totals.scans, 3U);
    EXPECT_EQ(poses_->lookups(), 3 * lookupsOfTurn);
}

TEST_F(TurnsInPieces, areForgottenWithATurnThatIsDropped) {
    auto source = std::make_unique<PiecewiseSource>(3);
    source->waitsForReader = false;
    source->beforePieces = [&](uint64_t turn) {
        EXPECT_TRUE(turn != 1 || poses_->waitFor(lookupsOfTurn));
    };
    PiecewiseSource& from = *source;
    LiveReduction reduction(std::move(source), setup_,
                            {.waiting = 1, .onFrame = [&](const LiveFramePtr& frame) {
                                 while (frame->arrived.number == 0 && !from.ended())
                                     std::this_thread::sleep_for(1ms);
                             }});
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    EXPECT_EQ(reduction.figures().turnsDropped, 1U);
    EXPECT_EQ(poses_->lookups(), 2 * lookupsOfTurn);
}

}  // namespace
}  // namespace offmap::live
