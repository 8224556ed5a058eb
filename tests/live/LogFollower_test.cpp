// SPDX-License-Identifier: BSD-3-Clause
#include "../support/LogFiles.h"
#include "../support/SimulatedRobot.h"
#include "../support/TemporaryFolder.h"

#include <offmap/live/LogFollower.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <thread>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;

/// A log of eight clouds with a pose before each, which another program writes bit by bit.
class Follow : public testing::TestWithParam<bool> {
 protected:
    Follow() {
        test::SimulatedRobot robot;
        test::Observations log;
        for (int i = 0; i < 8; ++i) {
            log.push_back(robot.localisation());
            log.push_back(robot.cloud("CLOUD", 40));
            robot.wait(0.1);
        }
        end_ = robot.now;
        const auto whole = folder_ / "whole.rawlog";
        const bool gzip = GetParam();
        test::writeLog(whole, log, gzip ? std::optional<int>(1) : std::nullopt);
        bytes_ = test::readFile(whole);
        std::ofstream(file_, std::ios::binary).flush();
    }

    void append(size_t from, size_t to) const {
        std::ofstream(file_, std::ios::binary | std::ios::app) << bytes_.substr(from, to - from);
    }

    std::shared_ptr<LivePoses> poses_ = std::make_shared<LivePoses>(0.5);
    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "growing.rawlog";
    std::string bytes_;
    mrpt::Clock::time_point end_;
};

TEST_P(Follow, deliversWhatAnotherProgramWrites) {
    LogFollower source(file_, {}, poses_, {});
    std::jthread writer([&] {
        constexpr size_t piece = 4000;
        for (size_t at = 0; at < bytes_.size(); at += piece) {
            append(at, std::min(at + piece, bytes_.size()));
            std::this_thread::sleep_for(5ms);
        }
    });
    for (uint64_t i = 0; i < 8; ++i) {
        const auto turn = source.next({});
        ASSERT_TRUE(turn) << source.health().message;
        EXPECT_EQ(turn->number, i);
    }
    EXPECT_EQ(source.health().state, SourceState::Running);
    EXPECT_EQ(poses_->added(), 8U);
    EXPECT_TRUE(poses_->at(end_).vehicleInMap);
}

// As a writer that was killed leaves it: in the middle of an entry, for ever.
TEST_P(Follow, stallsWhenTheWriterDiesAndGoesOnWithIt) {
    LogFollower source(file_, {}, poses_, {.stallsAfter = 50ms});
    append(0, bytes_.size() - 1000);
    std::jthread reader([&](const std::stop_token& stop) {
        uint64_t turns = 0;
        while (source.next(stop)) ++turns;
        EXPECT_EQ(turns, 8U);
    });
    while (source.health().state != SourceState::Stalled) std::this_thread::sleep_for(1ms);
    EXPECT_THAT(source.health().message, testing::HasSubstr("does not grow"));
    append(bytes_.size() - 1000, bytes_.size());
    while (source.health().received < 8) std::this_thread::sleep_for(1ms);
    reader.request_stop();
}

TEST_P(Follow, failsWhenTheLogBecomesShorter) {
    append(0, bytes_.size() - 1000);
    LogFollower source(file_, {}, poses_, {});
    std::jthread reader([&](const std::stop_token& stop) {
        while (source.next(stop)) {
        }
    });
    while (source.health().received < 1) std::this_thread::sleep_for(1ms);
    std::filesystem::resize_file(file_, 10);
    reader.join();
    EXPECT_EQ(source.health().state, SourceState::Failed);
    EXPECT_THAT(source.health().message, testing::HasSubstr("shorter"));
}

TEST_P(Follow, stopsWhileItWaits) {
    LogFollower source(file_, {}, poses_, {});
    std::jthread reader([&](const std::stop_token& stop) { EXPECT_FALSE(source.next(stop)); });
    std::this_thread::sleep_for(10ms);
    reader.request_stop();
}

INSTANTIATE_TEST_SUITE_P(AsWritten, Follow, testing::Bool(), [](const auto& written) {
    return std::string(written.param ? "gzip" : "plain");
});

}  // namespace
}  // namespace offmap::live
