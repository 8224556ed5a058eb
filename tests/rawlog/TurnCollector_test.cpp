// SPDX-License-Identifier: BSD-3-Clause
#include "../support/SweepMaker.h"

#include <offmap/rawlog/TurnCollector.h>

#include <gtest/gtest.h>

#include <vector>

namespace offmap::rawlog {
namespace {

using namespace std::chrono_literals;
using test::fanPose;
using test::fanWithoutReturns;
using Sizes = std::vector<size_t>;

/// Feeds columns `step` degrees apart and tells the sizes of the turns as they become complete.
class Sweep {
 public:
    explicit Sweep(double step, const SensorConfig& config = {})
        : step_(step), collector_(config) {}

    Sizes turn(int columns) {
        Sizes complete;
        for (int i = 0; i < columns; ++i) {
            const auto fan = fanWithoutReturns(fanPose(step_ * count_), {.time = now_});
            for (const auto& turn : collector_.add(*fan, count_)) complete.push_back(turn.size());
            ++count_;
            now_ += 10ms;
        }
        return complete;
    }
    void pause() { now_ += 5s; }
    Sizes finish() {
        Sizes complete;
        for (const auto& turn : collector_.finish()) complete.push_back(turn.size());
        return complete;
    }

 private:
    double step_;
    TurnCollector<int> collector_;
    int count_ = 0;
    std::chrono::milliseconds now_{0};
};

TEST(TurnCollector, turnsFollowEachOtherWithoutLoss) {
    for (const double step : {1.0, -1.0}) {
        Sweep sweep(step);
        // A turn waits until a fiftieth of the next one is there: 360 / 50 columns, and one more.
        EXPECT_EQ(sweep.turn(360 + 7), Sizes{});
        EXPECT_EQ(sweep.turn(1), Sizes{360});
        EXPECT_EQ(sweep.turn(2 * 360), (Sizes{360, 360}));
        EXPECT_EQ(sweep.finish(), Sizes{8});
    }
}

TEST(TurnCollector, columnsThatOverlapAtTheEndStayWithTheirTurn) {
    Sweep sweep(1.0);
    EXPECT_EQ(sweep.turn(362), Sizes{});
    EXPECT_EQ(sweep.finish(), Sizes{362});
}

TEST(TurnCollector, columnsThatOverlapBeforeAPauseStayWithTheirTurn) {
    Sweep sweep(1.0);
    EXPECT_EQ(sweep.turn(362), Sizes{});
    sweep.pause();
    EXPECT_EQ(sweep.turn(1), Sizes{362});
    EXPECT_EQ(sweep.finish(), Sizes{1});
}

TEST(TurnCollector, pauseEndsAnUnfinishedTurn) {
    Sweep sweep(1.0);
    EXPECT_EQ(sweep.turn(100), Sizes{});
    sweep.pause();
    EXPECT_EQ(sweep.turn(100), Sizes{100});
    EXPECT_EQ(sweep.finish(), Sizes{100});
}

TEST(TurnCollector, configuredNumberOfColumnsEndsATurnAtOnce) {
    SensorConfig config;
    config.columnsPerTurn = 36;
    Sweep sweep(1.0, config);
    EXPECT_EQ(sweep.turn(73), (Sizes{36, 36}));
    EXPECT_EQ(sweep.finish(), Sizes{1});
}

TEST(TurnCollector, nothingGivesNothing) {
    Sweep sweep(1.0);
    EXPECT_EQ(sweep.finish(), Sizes{});
}

}  // namespace
}  // namespace offmap::rawlog
