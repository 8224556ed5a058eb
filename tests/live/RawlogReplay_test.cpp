// SPDX-License-Identifier: BSD-3-Clause
#include "../support/LogFiles.h"
#include "../support/SimulatedRobot.h"
#include "../support/TemporaryFolder.h"

#include <offmap/live/RawlogReplay.h>

#include <gtest/gtest.h>

#include <limits>
#include <thread>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

/// A log of ten clouds, 0.1 s apart.
class Replay : public testing::Test {
 protected:
    Replay() {
        test::SimulatedRobot robot;
        test::Observations log;
        for (int i = 0; i < 10; ++i) {
            log.push_back(robot.cloud("CLOUD", 4));
            robot.wait(0.1);
        }
        test::writeLog(file_, log);
        rawlog::RawlogReader reader(file_);
        survey_ = rawlog::surveyLog(reader, config_, 100, [] {});
    }

    RawlogReplay replay(double speed, RawlogReplay::AtEnd atEnd = RawlogReplay::AtEnd::Stop) {
        return {file_, survey_, config_, speed, atEnd};
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "ten.rawlog";
    rawlog::Config config_;
    rawlog::LogSurvey survey_;
};

constexpr double noWait = std::numeric_limits<double>::infinity();

TEST_F(Replay, deliversAllTurnsInTheirOrder) {
    auto source = replay(noWait);
    EXPECT_TRUE(source.waits());
    for (uint64_t i = 0; i < 10; ++i) {
        const auto turn = source.next({});
        ASSERT_TRUE(turn);
        EXPECT_EQ(turn->number, i);
    }
    EXPECT_FALSE(source.next({}));
    EXPECT_EQ(source.health().state, SourceState::Ended);
    EXPECT_EQ(source.health().received, 10U);
}

// 0.9 s at ten times the speed. Waiting longer than asked for is no fault of the replay.
TEST_F(Replay, takesTheTimeThatTheLogTookBySpeed) {
    auto source = replay(10);
    const auto begin = Steady::now();
    while (source.next({})) {
    }
    EXPECT_GE(Steady::now() - begin, 89ms);
}

TEST_F(Replay, jumpsForthAndBack) {
    auto source = replay(noWait);
    source.jumpTo(7);
    EXPECT_EQ(source.next({})->number, 7U);
    source.jumpTo(2);
    EXPECT_EQ(source.next({})->number, 2U);
    EXPECT_EQ(source.next({})->number, 3U);
    source.jumpTo(100);
    EXPECT_FALSE(source.next({})) << "beyond the end";
}

TEST_F(Replay, stepsThroughAPause) {
    auto source = replay(1);
    source.pause();
    source.step();
    source.step();
    EXPECT_EQ(source.next({})->number, 0U);
    EXPECT_EQ(source.next({})->number, 1U);
    std::jthread later([&] {
        std::this_thread::sleep_for(20ms);
        source.setSpeed(noWait);
        source.resume();
    });
    EXPECT_EQ(source.next({})->number, 2U);
}

TEST_F(Replay, jumpsInAPauseAndWaitsThere) {
    auto source = replay(1);
    source.pause();
    source.jumpTo(3);
    source.jumpTo(6);
    EXPECT_EQ(source.next({})->number, 6U);
    const auto begin = Steady::now();
    std::jthread later([&] {
        std::this_thread::sleep_for(20ms);
        source.step();
    });
    EXPECT_EQ(source.next({})->number, 7U);
    EXPECT_GE(Steady::now() - begin, 19ms) << "the first jump has left nothing to do";
}

TEST_F(Replay, waitsAtTheEndForAJump) {
    auto source = replay(noWait, RawlogReplay::AtEnd::Wait);
    while (source.next({})->number < 9) {
    }
    std::jthread later([&] {
        std::this_thread::sleep_for(20ms);
        source.jumpTo(4);
    });
    EXPECT_EQ(source.next({})->number, 4U);
}

TEST_F(Replay, stopsWhileItWaits) {
    auto source = replay(0.001);
    source.next({});
    std::jthread reader([&](const std::stop_token& stop) { EXPECT_FALSE(source.next(stop)); });
    reader.request_stop();
}

}  // namespace
}  // namespace offmap::live
