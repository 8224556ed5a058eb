// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VelodyneStream.h"

#include <offmap/live/ScanSource.h>
#include <offmap/live/VelodyneTurns.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

namespace offmap::test {

/// Puts the pieces of turns together and compares them with the turns that follow them.
class TurnsFromPieces {
 public:
    void add(const live::TurnPiece& piece) {
        EXPECT_EQ(piece.turn, turns_);
        EXPECT_EQ(piece.firstPacket, packets_.size()) << "one behind the other, none missing";
        time_ = piece.packets->timestamp;
        const auto& packets = piece.packets->scan_packets;
        packets_.insert(packets_.end(), packets.begin(), packets.end());
    }

    /// All of it is in its pieces, but for what is too little for one.
    void expectBeginOf(const live::ArrivedTurn& turn) {
        const auto scan =
            std::dynamic_pointer_cast<const mrpt::obs::CObservationVelodyneScan>(turn.turn.front());
        ASSERT_TRUE(scan);
        const auto& all = scan->scan_packets;
        EXPECT_EQ(turn.number, turns_++);
        ASSERT_LE(packets_.size(), all.size());
        EXPECT_LE(all.size() - packets_.size(), live::packetsPerPiece);
        if (packets_.empty()) return;
        EXPECT_EQ(scan->timestamp, time_);
        EXPECT_EQ(std::memcmp(packets_.data(), all.data(), packets_.size() * sizeof all[0]), 0);
        packets_.clear();
    }

    uint64_t turns() const { return turns_; }

 private:
    std::vector<VelodynePacket> packets_;  // of the turn that goes on
    mrpt::Clock::time_point time_;
    uint64_t turns_ = 0;
};

}  // namespace offmap::test
