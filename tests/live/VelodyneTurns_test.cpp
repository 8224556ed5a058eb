// SPDX-License-Identifier: BSD-3-Clause
#include "VelodyneStream.h"

#include <offmap/live/VelodyneTurns.h>
#include <offmap/rawlog/VelodyneModel.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace offmap::live {
namespace {

using test::VelodyneStream;

const auto now = mrpt::Clock::fromDouble(1.7e9);

/// The turns of packets [from, to) of the stream.
std::vector<VelodyneTurn> turnsOf(VelodyneTurns& turns, uint64_t from, uint64_t to) {
    static const VelodyneStream stream;
    std::vector<VelodyneTurn> all;
    for (uint64_t n = from; n < to; ++n) {
        const auto turn = turns.add(stream.packet(n), now + std::chrono::milliseconds(n));
        if (turn) all.push_back(turn);
    }
    return all;
}

TEST(VelodyneTurns, everyPacketIsInOneTurn) {
    VelodyneTurns turns("VLP16");
    auto all = turnsOf(turns, 0, 10 * 75);
    if (const auto rest = turns.finish()) all.push_back(rest);
    const VelodyneStream stream;
    uint64_t n = 0;
    for (const VelodyneTurn& turn : all) {
        for (const auto& packet : turn->scan_packets)
            EXPECT_EQ(test::rangesOf(packet), test::rangesOf(stream.packet(n++)));
    }
    EXPECT_EQ(n, 750U);
    EXPECT_EQ(turns.packetsMissing(), 0U);
}

// The sample begins somewhere on the circle; from the first passage of 0 degrees on, each turn is
// one round of the sample's 75 packets.
TEST(VelodyneTurns, endWhereTheHeadPassesItsZero) {
    VelodyneTurns turns("VLP16");
    const auto all = turnsOf(turns, 0, 10 * 75);
    ASSERT_GE(all.size(), 9U);
    for (size_t i = 1; i < all.size(); ++i) {
        EXPECT_EQ(all[i]->scan_packets.size(), 75U) << i;
        EXPECT_LT(all[i]->scan_packets.front().blocks[0].rotation(), 500) << "5 degrees";
    }
    EXPECT_EQ(all[1]->sensorLabel, "VLP16");
    const auto packetsBefore = static_cast<int64_t>(all[0]->scan_packets.size());
    EXPECT_EQ(all[1]->timestamp, now + std::chrono::milliseconds(packetsBefore));
}

TEST(VelodyneTurns, areHandedOverInPiecesAsTheyCome) {
    const VelodyneStream stream;
    VelodyneTurns turns("VLP16");
    std::vector<size_t> firsts;
    std::vector<test::VelodynePacket> packets;
    uint64_t n = 0;
    EXPECT_FALSE(turns.piece(1)) << "nothing has come";
    for (VelodyneTurn turn; !turn; ++n) {
        turn = turns.add(stream.packet(n), now + std::chrono::milliseconds(n));
        const auto piece = turns.piece(4);
        if (!piece) continue;
        EXPECT_EQ(piece->firstPacket, packets.size());
        EXPECT_EQ(piece->packets->scan_packets.size(), 4U);
        EXPECT_EQ(piece->packets->sensorLabel, "VLP16");
        EXPECT_EQ(piece->packets->timestamp, now) << "the turn's";
        for (const auto& packet : piece->packets->scan_packets) packets.push_back(packet);
    }
    EXPECT_GT(packets.size(), 8U);
    EXPECT_GE(packets.size() + 4, n) << "but the last few, with which the turn was complete";
    for (uint64_t i = 0; i < packets.size(); ++i) {
        EXPECT_EQ(test::rangesOf(packets[i]), test::rangesOf(stream.packet(i)));
    }
    EXPECT_FALSE(turns.piece(1)) << "of the turn that is complete";
    turns.add(stream.packet(n), now + std::chrono::seconds(1));
    const auto next = turns.piece(1);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->firstPacket, 0U);
    EXPECT_EQ(next->packets->timestamp, now + std::chrono::seconds(1));
}

TEST(VelodyneTurns, countWhatIsMissingByTheStamps) {
    VelodyneTurns turns("VLP16");
    turnsOf(turns, 0, 100);
    turnsOf(turns, 103, 200);
    turnsOf(turns, 201, 300);
    EXPECT_EQ(turns.packetsMissing(), 4U);
}

// Else two turns would come as one.
TEST(VelodyneTurns, endAlsoWhereThePacketThatReachesZeroDidNotCome) {
    VelodyneTurns turns("VLP16");
    ASSERT_EQ(turnsOf(turns, 0, 149).size(), 1U);
    const auto more = turnsOf(turns, 150, 225);
    ASSERT_EQ(more.size(), 2U);
    EXPECT_EQ(more[0]->scan_packets.size(), 74U);
    EXPECT_EQ(more[1]->scan_packets.size(), 75U);
    EXPECT_EQ(turns.packetsMissing(), 1U);
}

TEST(VelodyneTurns, theHourMayBeginAnew) {
    const auto lastOfHour = static_cast<uint64_t>(3.6e9 / VelodyneStream::period);
    VelodyneTurns turns("VLP16");
    turnsOf(turns, lastOfHour - 5, lastOfHour + 5);
    EXPECT_EQ(turns.packetsMissing(), 0U);
}

TEST(VelodyneTurns, afterAnEndWhatWasNotSentIsNotMissing) {
    VelodyneTurns turns("VLP16");
    turnsOf(turns, 0, 100);
    EXPECT_TRUE(turns.finish());
    EXPECT_FALSE(turns.finish()) << "nothing is left";
    turnsOf(turns, 400, 500);
    EXPECT_EQ(turns.packetsMissing(), 0U);
}

TEST(VelodyneTurns, anotherModelIsRefused) {
    VelodyneTurns turns("VLP16");
    auto packet = test::emptyVlp16Packet(0);
    packet.velodyne_model_ID = 0x28;
    EXPECT_THROW(turns.add(packet, now), std::invalid_argument);
    EXPECT_THROW(turns.add(test::emptyHdl64Packet(0), now), std::invalid_argument);
    EXPECT_FALSE(turns.finish());
}

// Two sensors at one port: a turn of both could not be decoded.
TEST(VelodyneTurns, aSecondModelIsRefusedWhileTheFirstGoesOn) {
    VelodyneTurns turns("VLP16");
    turnsOf(turns, 0, 40);
    EXPECT_THROW(turns.add(test::emptyHdl32Packet(0), now), std::invalid_argument);
    const auto rest = turnsOf(turns, 40, 75);
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_FALSE(rawlog::unsupportedVelodyne(*rest.front()));
    EXPECT_EQ(turns.packetsMissing(), 0U);
    turns.finish();
    EXPECT_FALSE(turns.add(test::emptyHdl32Packet(0), now)) << "it goes on alone";
    EXPECT_TRUE(turns.finish());
}

}  // namespace
}  // namespace offmap::live
