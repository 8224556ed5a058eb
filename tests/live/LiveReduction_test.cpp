// SPDX-License-Identifier: BSD-3-Clause
#include "TurnsInMemory.h"

#include <offmap/rawlog/ScanClasses.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;
using test::officeSetup;
using test::TurnsInMemory;

constexpr auto longEnough = 60s;

TEST(LiveReduction, reducesAllThatAWaitingSourceDelivers) {
    std::vector<uint64_t> numbers;
    LiveReduction reduction(
        std::make_unique<TurnsInMemory>(20), officeSetup(),
        {.onFrame = [&](const LiveFramePtr& frame) { numbers.push_back(frame->arrived.number); }});
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    EXPECT_EQ(reduction.failure(), "");
    ASSERT_EQ(numbers.size(), 20U);
    for (uint64_t i = 0; i < 20; ++i) EXPECT_EQ(numbers[i], i);
    const LiveFigures figures = reduction.figures();
    EXPECT_EQ(figures.totals.scans, 20U);
    EXPECT_EQ(figures.turnsDropped, 0U);
    EXPECT_EQ(figures.source.state, SourceState::Ended);
    ASSERT_TRUE(reduction.latest());
    EXPECT_EQ(reduction.latest()->arrived.number, 19U);
    EXPECT_GT(reduction.latest()->reduced.record.removed(), 0U);
    EXPECT_GT(reduction.latest()->latency, 0);
}

TEST(LiveReduction, removesWhatTheBatchRemoves) {
    LiveReduction reduction(std::make_unique<TurnsInMemory>(1), officeSetup());
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    const LiveFramePtr frame = reduction.latest();
    ASSERT_TRUE(frame);
    const LiveSetup setup = officeSetup();
    rawlog::TurnReducer batch(*setup.map, *setup.poses, setup.config, setup.output);
    const auto& turn = frame->arrived.turn;
    const auto* scanClass = rawlog::scanClassOf(*turn.front(), setup.config.sensor);
    EXPECT_EQ(batch.reduce(turn, *scanClass).removedSlots, frame->reduced.removedSlots);
}

// The first turn is held until all others have come: of these the two that may wait are left.
TEST(LiveReduction, dropsTheOldestAndCountsThem) {
    std::vector<uint64_t> numbers;
    LiveReduction* running = nullptr;
    std::mutex built;
    std::unique_lock building(built);
    const auto onFrame = [&](const LiveFramePtr& frame) {
        const std::lock_guard wait(built);
        while (running->figures().source.state != SourceState::Ended)
            std::this_thread::sleep_for(1ms);
        numbers.push_back(frame->arrived.number);
    };
    LiveReduction reduction(std::make_unique<TurnsInMemory>(10, false), officeSetup(),
                            {.waiting = 2, .onFrame = onFrame});
    running = &reduction;
    building.unlock();
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    const LiveFigures figures = reduction.figures();
    EXPECT_EQ(figures.totals.scans + figures.turnsDropped, 10U);
    EXPECT_GE(figures.turnsDropped, 6U) << "at most one in work, one taken before, two waiting";
    EXPECT_EQ(numbers.back(), 9U) << "the newest is always reduced";
}

/// As a sensor: turns come when they come, every 2 ms.
class TurnsAtARate : public TurnsInMemory {
 public:
    explicit TurnsAtARate(size_t turns) : TurnsInMemory(turns, false) {}
    std::optional<ArrivedTurn> next(const std::stop_token& stop) override {
        std::this_thread::sleep_for(2ms);
        return TurnsInMemory::next(stop);
    }
};

// A turn waits for the one in work, for those that came before it and may wait, and for itself:
// waiting + 1 of them, each as slow as the slowest. Who is never idle ends one each cycle.
TEST(LiveReduction, tooManyTurnsDoNotMakeItLate) {
    constexpr size_t waiting = 3;
    double slowest = 0, latest = 0;  // [ms]
    SteadyTime before = std::chrono::steady_clock::now();
    LiveReduction reduction(std::make_unique<TurnsAtARate>(150), officeSetup(),
                            {.waiting = waiting, .onFrame = [&](const LiveFramePtr& frame) {
                                 std::this_thread::sleep_for(10ms);
                                 const auto now = std::chrono::steady_clock::now();
                                 const std::chrono::duration<double, std::milli> cycle =
                                     now - before;
                                 before = now;
                                 slowest = std::max(slowest, cycle.count());
                                 latest = std::max(latest, frame->latency);
                             }});
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    const LiveFigures figures = reduction.figures();
    EXPECT_GT(figures.turnsDropped, 0U) << "the test must be too fast for it";
    EXPECT_EQ(figures.totals.scans + figures.turnsDropped, 150U);
    EXPECT_LE(latest, (waiting + 1) * slowest);
}

/// Delivers one turn and then nothing, without an end.
class OneTurn : public TurnsInMemory {
 public:
    OneTurn() : TurnsInMemory(1) {}
    std::optional<ArrivedTurn> next(const std::stop_token& stop) override {
        if (auto turn = TurnsInMemory::next(stop)) return turn;
        while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
        return std::nullopt;
    }
};

TEST(LiveReduction, aChangeReducesTheLatestTurnAgain) {
    std::atomic<int> told = 0;
    LiveOptions options;
    options.onLatest = [&](const LiveFramePtr&) { ++told; };
    LiveReduction reduction(std::make_unique<OneTurn>(), officeSetup(), options);
    while (told < 1) std::this_thread::sleep_for(1ms);
    const LiveFramePtr before = reduction.latest();
    LiveSetup tuned = officeSetup();
    tuned.config.reduction.vertical.minLength = 100;  // [m]: no segment at all
    reduction.change(tuned);
    while (told < 2) std::this_thread::sleep_for(1ms);
    EXPECT_NE(reduction.latest(), before);
    EXPECT_GT(before->reduced.record.removed(), 0U);
    EXPECT_EQ(reduction.latest()->reduced.record.removed(), 0U);
    EXPECT_EQ(reduction.figures().totals.scans, 1U) << "it is the same turn";
}

TEST(LiveReduction, whatOnFrameThrowsEndsIt) {
    LiveReduction reduction(
        std::make_unique<TurnsInMemory>(20), officeSetup(),
        {.onFrame = [](const LiveFramePtr&) { throw std::runtime_error("disk full"); }});
    ASSERT_TRUE(reduction.waitUntilFinished(longEnough));
    EXPECT_EQ(reduction.failure(), "disk full");
    EXPECT_EQ(reduction.figures().totals.scans, 1U);
}

TEST(LiveReduction, canBeDestroyedWhileItWorks) {
    for (int i = 0; i < 5; ++i) {
        LiveReduction reduction(std::make_unique<TurnsInMemory>(50), officeSetup());
        while (!reduction.latest()) std::this_thread::sleep_for(1ms);
    }
}

TEST(LiveReduction, aConfigurationThatIsNotValidIsRefused) {
    LiveSetup setup = officeSetup();
    setup.config.pose.maxAge = -1;
    EXPECT_THROW(LiveReduction(std::make_unique<TurnsInMemory>(1), setup), std::invalid_argument);
}

}  // namespace
}  // namespace offmap::live
