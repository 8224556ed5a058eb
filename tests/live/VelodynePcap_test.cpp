// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"
#include "CaptureFile.h"
#include "TurnsFromPieces.h"

#include <offmap/live/VelodynePcap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <limits>
#include <thread>

namespace offmap::live {
namespace {

constexpr double noWait = std::numeric_limits<double>::infinity();

class Pcap : public testing::Test {
 protected:
    std::filesystem::path written(const std::string& bytes) const {
        std::ofstream(file_, std::ios::binary) << bytes;
        return file_;
    }
    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "drive.pcap";
};

TEST_F(Pcap, deliversAllPacketsInTurns) {
    VelodynePcap source(written(test::velodyneCapture(400)), "VLP16", noWait);
    EXPECT_TRUE(source.waits());
    size_t packets = 0;
    while (const auto turn = source.next({})) {
        using Scan = mrpt::obs::CObservationVelodyneScan;
        const auto scan = std::dynamic_pointer_cast<const Scan>(turn->turn.front());
        packets += scan->scan_packets.size();
        EXPECT_GE(mrpt::Clock::toDouble(scan->timestamp), 1.7e9 - 1e-3);
        EXPECT_LE(mrpt::Clock::toDouble(scan->timestamp), 1.7e9 + 1) << "the time of the capture";
    }
    EXPECT_EQ(packets, 400U) << "the last turn as well";
    EXPECT_EQ(source.health().state, SourceState::Ended);
    EXPECT_EQ(source.health().packetsMissing, 0U);
}

// 400 packets are 531 ms: at that speed, 27 ms.
TEST_F(Pcap, handsOverItsTurnsInPieces) {
    VelodynePcap source(written(test::velodyneCapture(400)), "VLP16", 20);
    test::TurnsFromPieces pieces;
    source.onPiece([&](const TurnPiece& piece) { pieces.add(piece); });
    while (const auto turn = source.next({})) pieces.expectBeginOf(*turn);
    EXPECT_EQ(pieces.turns(), source.health().received);
    EXPECT_GE(pieces.turns(), 5U);
}

TEST_F(Pcap, withoutWaitingTurnsComeWholeOnly) {
    VelodynePcap source(written(test::velodyneCapture(400)), "VLP16", noWait);
    source.onPiece([](const TurnPiece&) { ADD_FAILURE() << "of no use"; });
    while (source.next({})) {
    }
    EXPECT_GE(source.health().received, 5U);
}

// Nothing is due before it came: pieces, and a turn with its last packet.
TEST_F(Pcap, piecesAndTurnsComeWhenTheirLastPacketDid) {
    using Steady = std::chrono::steady_clock;
    VelodynePcap source(written(test::velodyneCapture(150)), "VLP16", 1);
    size_t packets = 0;
    const auto begin = Steady::now();  // the first piece is due at once
    const auto expectNotBefore = [&](size_t packet) {
        const auto due = std::chrono::duration<double, std::micro>(test::VelodyneStream::period) *
                         static_cast<double>(packet - packetsPerPiece);
        EXPECT_GE(Steady::now() - begin, due - std::chrono::microseconds(5)) << packet;
    };
    source.onPiece([&](const TurnPiece& piece) {
        packets += piece.packets->scan_packets.size();
        expectNotBefore(packets);
    });
    const auto turn = source.next({});
    ASSERT_TRUE(turn);
    const auto scan =
        std::dynamic_pointer_cast<const mrpt::obs::CObservationVelodyneScan>(turn->turn.front());
    EXPECT_GT(packets, 0U);
    expectNotBefore(scan->scan_packets.size());
}

TEST_F(Pcap, stopsWhileAPieceIsAwaited) {
    VelodynePcap source(written(test::velodyneCapture(400)), "VLP16", 1e-3);
    source.onPiece([](const TurnPiece&) {});
    std::jthread reader([&](const std::stop_token& stop) { EXPECT_FALSE(source.next(stop)); });
    reader.request_stop();
    reader.join();
    EXPECT_NE(source.health().state, SourceState::Ended);
    EXPECT_NE(source.health().state, SourceState::Failed);
}

TEST_F(Pcap, aDamagedCaptureDeliversWhatStandsBefore) {
    const std::string whole = test::velodyneCapture(200);
    VelodynePcap source(written(whole.substr(0, whole.size() - 100)), "VLP16", noWait);
    EXPECT_TRUE(source.next({}));
    while (source.next({})) {
    }
    EXPECT_EQ(source.health().state, SourceState::Failed);
    EXPECT_THAT(source.health().message, testing::HasSubstr("drive.pcap"));
}

TEST_F(Pcap, aCaptureOfSomethingElseFailsWithItsReason) {
    std::string bytes = test::captureHead();
    test::addFrame(bytes, 1.7e9, "hello", 5);
    VelodynePcap source(written(bytes), "VLP16", noWait);
    EXPECT_FALSE(source.next({}));
    EXPECT_EQ(source.health().state, SourceState::Failed);
    EXPECT_THAT(source.health().message, testing::HasSubstr("no packets of a Velodyne"));
}

TEST_F(Pcap, whatIsNoCaptureIsRefused) {
    EXPECT_THROW(VelodynePcap(written("hello"), "VLP16", 1), std::runtime_error);
    EXPECT_THROW(VelodynePcap(folder_ / "none.pcap", "VLP16", 1), std::runtime_error);
}

}  // namespace
}  // namespace offmap::live
