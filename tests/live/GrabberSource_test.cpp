// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"
#include "CaptureFile.h"
#include "FakeLidar.h"

#include <offmap/live/GrabberSource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;
using test::FakeLidar;
using testing::HasSubstr;
using Does = FakeLidar::Does;

class Grab : public testing::Test {
 protected:
    Grab() {
        FakeLidar::doRegister();
        FakeLidar::does = Does::Work;
        FakeLidar::initialised = FakeLidar::blocked = 0;
    }

    GrabberSource sourceOf(const std::string& content) const {
        std::ofstream(file_) << content;
        return {file_, {}, poses_, quick()};
    }
    static GrabberSource::Options quick() {
        return {.stallsAfter = 100ms, .triesAgainAfter = 10ms, .waitsForDrivers = 50ms};
    }

    /// Reads on until it is so.
    template <class Condition>
    static void readUntil(GrabberSource& source, Condition&& condition) {
        std::jthread reader([&](const std::stop_token& stop) {
            while (source.next(stop)) {
            }
        });
        while (!condition(source.health())) std::this_thread::sleep_for(1ms);
    }

    static constexpr const char* fake = "[FAKE]\ndriver = FakeLidar\nprocess_rate = 200\n";

    std::shared_ptr<LivePoses> poses_ = std::make_shared<LivePoses>(0.5);
    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "sensors.ini";
};

TEST_F(Grab, deliversScansAndKeepsPoses) {
    auto source = sourceOf(fake);
    for (uint64_t i = 0; i < 3; ++i) {
        const auto turn = source.next({});
        ASSERT_TRUE(turn);
        EXPECT_EQ(turn->number, i);
        EXPECT_EQ(turn->turn.front()->sensorLabel, "FAKE");
        EXPECT_TRUE(poses_->at(turn->turn.front()->timestamp).vehicleInMap);
    }
    EXPECT_EQ(source.health().state, SourceState::Running);
    EXPECT_EQ(source.health().connectionsLost, 0U);
}

// MRPT's driver does not deliver the last turn of a capture, and begins again at its end.
TEST_F(Grab, deliversTheTurnsOfAVelodyne) {
    const auto capture = folder_ / "drive.pcap";
    std::ofstream(capture, std::ios::binary) << test::velodyneCapture(4 * 75);
    auto source = sourceOf(
        "[Velodyne]\ndriver = CVelodyneScanner\nmodel = VLP16\n"
        "process_rate = 100000\nsensorLabel = Top\npcap_read_fast = true\n"
        "pcap_input = " +
        capture.string());
    for (int i = 0; i < 3; ++i) {
        const auto turn = source.next({});
        ASSERT_TRUE(turn);
        using Scan = mrpt::obs::CObservationVelodyneScan;
        const auto scan = std::dynamic_pointer_cast<const Scan>(turn->turn.front());
        ASSERT_TRUE(scan);
        EXPECT_EQ(scan->sensorLabel, "Top_SCAN");
        EXPECT_EQ(scan->scan_packets.size(), 75U);
    }
}

TEST_F(Grab, aDriverThatCannotBeginIsTriedAgain) {
    FakeLidar::does = Does::ThrowAtInitialize;
    auto source = sourceOf(fake);
    readUntil(source, [](const auto& now) { return now.state == SourceState::Stalled; });
    EXPECT_THAT(source.health().message, HasSubstr("[FAKE] no cable"));
    EXPECT_EQ(source.health().connectionsLost, 0U) << "there was none";
    FakeLidar::does = Does::Work;
    readUntil(source, [](const auto& now) { return now.state == SourceState::Running; });
    EXPECT_EQ(source.health().message, "");
    EXPECT_GE(FakeLidar::initialised, 2);
}

TEST_F(Grab, aDriverThatFailsIsMadeAnew) {
    auto source = sourceOf(fake);
    readUntil(source, [](const auto& now) { return now.received > 2; });
    FakeLidar::does = Does::ThrowAtProcess;
    readUntil(source, [](const auto& now) { return now.state == SourceState::Stalled; });
    EXPECT_THAT(source.health().message, HasSubstr("unplugged"));
    EXPECT_EQ(source.health().connectionsLost, 1U);
    const uint64_t before = source.health().received;
    FakeLidar::does = Does::Work;
    readUntil(source, [&](const auto& now) { return now.received > before; });
    EXPECT_EQ(source.health().state, SourceState::Running);
    EXPECT_EQ(source.health().connectionsLost, 1U);
    EXPECT_GE(FakeLidar::initialised, 2);
}

TEST_F(Grab, aDriverThatTellsOfAnErrorIsAskedAgain) {
    auto source = sourceOf(fake);
    readUntil(source, [](const auto& now) { return now.received > 2; });
    FakeLidar::does = Does::TellOfError;
    readUntil(source, [](const auto& now) { return now.state == SourceState::Stalled; });
    FakeLidar::does = Does::Work;
    readUntil(source, [](const auto& now) { return now.state == SourceState::Running; });
    EXPECT_EQ(FakeLidar::initialised, 1) << "it helps itself";
    EXPECT_EQ(source.health().connectionsLost, 1U);
}

TEST_F(Grab, silenceCountsAsStalled) {
    auto source = sourceOf(fake);
    readUntil(source, [](const auto& now) { return now.received > 2; });
    FakeLidar::does = Does::Nothing;
    readUntil(source, [](const auto& now) { return now.state == SourceState::Stalled; });
    EXPECT_THAT(source.health().message, HasSubstr("no scans"));
    EXPECT_EQ(source.health().connectionsLost, 1U);
}

TEST_F(Grab, oneThatFailsDoesNotStopTheOthers) {
    auto source = sourceOf(std::string(fake) +
                           "[Velodyne]\ndriver = CVelodyneScanner\nmodel = VLP16\n"
                           "process_rate = 1000\npcap_input = /nowhere.pcap\n");
    EXPECT_EQ(source.sensors(), 2U);
    readUntil(source, [](const auto& now) { return now.received > 2 && !now.message.empty(); });
    EXPECT_EQ(source.health().state, SourceState::Running);
    EXPECT_THAT(source.health().message, HasSubstr("[Velodyne]"));
}

TEST_F(Grab, turnsThatNobodyTakesDoNotPileUp) {
    auto source = sourceOf(fake);
    while (source.health().received < 20) std::this_thread::sleep_for(1ms);
    EXPECT_THAT(source.health().message, HasSubstr("turns that nobody took"));
    const auto turn = source.next({});
    ASSERT_TRUE(turn);
    EXPECT_GE(turn->number, 4U) << "at most 16 wait";
}

// A driver that never comes back must not hold up the end of the program.
TEST_F(Grab, endsAlthoughADriverIsBusy) {
    std::ofstream(file_) << fake;
    auto source = std::make_unique<GrabberSource>(file_, rawlog::Config{}, poses_, quick());
    FakeLidar::does = Does::Block;
    while (FakeLidar::blocked == 0) std::this_thread::sleep_for(1ms);
    const auto begin = std::chrono::steady_clock::now();
    source.reset();
    // 50 ms for the driver; the rest is for a machine that is busy.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
    EXPECT_EQ(FakeLidar::does, Does::Block) << "it is busy still";
    FakeLidar::does = Does::Work;
}

TEST_F(Grab, stopsWhileNothingComes) {
    FakeLidar::does = Does::Nothing;
    auto source = sourceOf(fake);
    std::jthread reader([&](const std::stop_token& stop) { EXPECT_FALSE(source.next(stop)); });
    reader.request_stop();
}

}  // namespace
}  // namespace offmap::live
