// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SharedData.h"
#include "../support/SweepMaker.h"

#include <offmap/rawlog/SweepTurns.h>

#include <gtest/gtest.h>

#include <vector>

namespace offmap::rawlog {
namespace {

using namespace std::chrono_literals;
using test::Fan;
using test::fanPose;
using test::fanWithoutReturns;

/// Sizes of the turns that the fans make; the last one may not be complete.
std::vector<size_t> turnsOf(const std::vector<std::shared_ptr<Fan>>& fans,
                            const SensorConfig& config = {}) {
    SweepTurns turns(config);
    std::vector<size_t> sizes;
    for (const auto& fan : fans) {
        if (turns.startsNewTurn(*fan)) sizes.push_back(0);
        if (sizes.empty()) throw std::logic_error("the first column starts no turn");
        ++sizes.back();
    }
    return sizes;
}

std::vector<std::shared_ptr<Fan>> fansAt(const std::vector<double>& yaws) {
    std::vector<std::shared_ptr<Fan>> fans;
    for (const double yaw : yaws) {
        fans.push_back(fanWithoutReturns(fanPose(yaw), {.time = 10ms * fans.size()}));
    }
    return fans;
}

std::vector<double> evenly(double first, double step, int count) {
    std::vector<double> yaws;
    for (int i = 0; i < count; ++i) yaws.push_back(first + step * i);
    return yaws;
}

TEST(SweepTurns, turnEndsWhereTheAzimuthHasGoneRound) {
    for (const double step : {2.0, -2.0}) {
        EXPECT_EQ(turnsOf(fansAt(evenly(77, step, 400))), (std::vector<size_t>{180, 180, 40}));
    }
}

TEST(SweepTurns, noiseOfAnEncoderCutsNoTurnShort) {
    auto yaws = evenly(0, 2, 360);
    for (size_t i = 0; i < yaws.size(); ++i) yaws[i] += i % 2 == 0 ? 0.04 : -0.04;
    EXPECT_EQ(turnsOf(fansAt(yaws)), (std::vector<size_t>{180, 180}));
}

TEST(SweepTurns, columnLimitEndsATurn) {
    SensorConfig config;
    config.columnsPerTurn = 50;
    EXPECT_EQ(turnsOf(fansAt(evenly(0, 1, 120)), config), (std::vector<size_t>{50, 50, 20}));
}

TEST(SweepTurns, pauseEndsATurnEitherWayInTime) {
    for (const auto jump : {1100ms, -1100ms}) {
        auto fans = fansAt(evenly(0, 1, 30));
        for (size_t i = 12; i < fans.size(); ++i) fans[i]->timestamp += jump;
        EXPECT_EQ(turnsOf(fans), (std::vector<size_t>{12, 18}));
    }
    auto fans = fansAt(evenly(0, 1, 30));
    for (size_t i = 12; i < fans.size(); ++i) fans[i]->timestamp += 900ms;
    EXPECT_EQ(turnsOf(fans), (std::vector<size_t>{30}));
}

TEST(SweepTurns, turningBackEndsATurn) {
    for (const double sign : {1.0, -1.0}) {
        auto yaws = evenly(0, sign * 0.4, 100);
        const auto back = evenly(yaws.back(), sign * -0.4, 100);
        yaws.insert(yaws.end(), back.begin() + 1, back.end());
        // 0.4 and 0.8 degrees back still belong to the first.
        EXPECT_EQ(turnsOf(fansAt(yaws)), (std::vector<size_t>{102, 97}));
    }
}

TEST(SweepTurns, scannerThatStandsStillEndsItsTurnsAsWell) {
    const auto fan = fanWithoutReturns(fanPose(10));
    SweepTurns turns({});
    uint32_t started = 0;
    for (int i = 0; i < 250'000; ++i) started += turns.startsNewTurn(*fan) ? 1 : 0;
    EXPECT_EQ(started, 3U);
}

TEST(SweepTurns, onlyTheAzimuthsWrapCountsAsWrapped) {
    SensorConfig config;
    config.columnsPerTurn = 200;
    SweepTurns turns(config);
    std::vector<bool> wrapped;
    auto yaws = evenly(0, 2, 181);          // round, once
    const auto slow = evenly(0, 0.1, 210);  // 200 columns, the wrap's one included
    yaws.insert(yaws.end(), slow.begin() + 1, slow.end());
    for (const auto& fan : fansAt(yaws)) {
        if (turns.startsNewTurn(*fan)) wrapped.push_back(turns.wrapped());
    }
    EXPECT_EQ(wrapped, (std::vector<bool>{false, true, false}));
}

TEST(SweepTurns, resetForgetsTheTurn) {
    SweepTurns turns({});
    const auto fans = fansAt({0, 1});
    EXPECT_TRUE(turns.startsNewTurn(*fans[0]));
    EXPECT_FALSE(turns.startsNewTurn(*fans[1]));
    turns.reset();
    EXPECT_TRUE(turns.startsNewTurn(*fans[1]));
}

// The first log ends 0.2 degrees short of a full turn, the second 0.4 degrees past it.
TEST(SweepTurns, realTurnsEndWhereTheyHaveGoneRound) {
    OFFMAP_NEEDS_SHARED_DATA()
    const auto first = test::observationsIn<Fan>(test::sharedData("room/room1.rawlog"));
    EXPECT_EQ(turnsOf(first), (std::vector<size_t>{636}));
    const auto second = test::observationsIn<Fan>(test::sharedData("room/room2.rawlog"));
    EXPECT_EQ(turnsOf(second), (std::vector<size_t>{634, 2}));
}

bool isSweep(const std::vector<std::shared_ptr<Fan>>& fans) {
    SweepDetector detector;
    for (const auto& fan : fans) detector.see(*fan);
    return detector.isSweep();
}

TEST(SweepDetector, turningVerticalFansAreASweep) {
    EXPECT_TRUE(isSweep(fansAt({0, 0.6, 1.2})));
    EXPECT_TRUE(isSweep(fansAt({179.7, -178})));
}

TEST(SweepDetector, standingFansAreNone) {
    EXPECT_FALSE(isSweep({}));
    EXPECT_FALSE(isSweep(fansAt({0, 0.4, -0.4, 0.9})));
    EXPECT_FALSE(isSweep(fansAt({179.7, -179.7})));
}

TEST(SweepDetector, oneLevelScanMakesTheLabelNone) {
    auto fans = fansAt({0, 10, 20});
    fans[1]->sensorPose = mrpt::poses::CPose3D();
    EXPECT_FALSE(isSweep(fans));
}

}  // namespace
}  // namespace offmap::rawlog
