// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/VelodyneModel.h>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdint>
#include <optional>
#include <string>

namespace offmap::live {

using VelodynePacket = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;
using VelodyneTurn = mrpt::obs::CObservationVelodyneScan::Ptr;

/// That are worth a piece: 5 ms of a VLP-16.
inline constexpr size_t packetsPerPiece = 4;

/// Some packets of a turn.
struct VelodynePiece {
    size_t firstPacket = 0;  ///< of the turn, from 0
    VelodyneTurn packets;    ///< as the turn, with these packets only
};

/// Puts the packets of a VLP-16 or HDL-32E together into turns. Every packet is in one turn, so all
/// returns are. A turn ends where the head passes its 0 degrees: with the packet that reaches it,
/// if the one before tells how far a packet goes, not with the first one behind. Only where the
/// former did not come does the latter end it.
class VelodyneTurns {
 public:
    explicit VelodyneTurns(std::string label) : label_(std::move(label)) {}

    /// \param arrived the turn's time is that of its first packet
    /// \return the turn that this packet completes, or shows to be complete; null if it goes on
    /// \throw std::invalid_argument saying why, if it is a packet of neither model, or of another
    /// one than those before
    VelodyneTurn add(const VelodynePacket& packet, mrpt::Clock::time_point arrived);

    /// What has come of the turn that goes on since the last call; none if it is less than that
    /// many packets.
    std::optional<VelodynePiece> piece(size_t leastPackets);

    /// What there is of the turn that goes on; null if there is none. The next packet begins a new
    /// one, and what is missing in between is not counted: for a sensor that was switched off.
    VelodyneTurn finish();

    /// How many packets did not come, by the stamps of those that did.
    uint64_t packetsMissing() const { return missing_; }

 private:
    void countMissing(uint32_t stamp, double period);
    struct Passage {
        bool ended = false;  ///< the turn, before this packet: the one that reaches 0 did not come
        bool ends = false;   ///< the turn, with this packet: the next would begin behind 0
    };
    Passage passageTo(int rotation);

    std::string label_;
    const rawlog::VelodyneModel* model_ = nullptr;  // of the packets; null: none have come
    VelodyneTurn turn_;
    size_t inPieces_ = 0;                // of its packets
    std::optional<uint32_t> lastStamp_;  // [us] of the hour
    std::optional<int> lastRotation_;    // [1/100 deg] of a packet's first block, clockwise
    int swept_ = 0;                      // [1/100 deg] by the turn so far
    uint64_t missing_ = 0;
};

}  // namespace offmap::live
