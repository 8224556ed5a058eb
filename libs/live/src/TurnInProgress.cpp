// SPDX-License-Identifier: BSD-3-Clause
#include "TurnInProgress.h"

#include <algorithm>
#include <memory>
#include <span>

namespace offmap::live {

using Scan = mrpt::obs::CObservationVelodyneScan;

bool TurnInProgress::add(const TurnPiece& piece) {
    if (piece.firstPacket == 0) {
        soFar_ = std::make_shared<Scan>(*piece.packets);
        number_ = piece.turn;
        return true;
    }
    const bool follows =
        soFar_ && piece.turn == number_ && piece.firstPacket == soFar_->scan_packets.size();
    if (!follows) return false;
    const auto& packets = piece.packets->scan_packets;
    soFar_->scan_packets.insert(soFar_->scan_packets.end(), packets.begin(), packets.end());
    return true;
}

bool TurnInProgress::begins(const rawlog::Turn& turn) const {
    if (!soFar_ || turn.size() != 1) return false;
    const auto whole = std::dynamic_pointer_cast<const Scan>(turn.front());
    if (!whole || whole->timestamp != soFar_->timestamp ||
        whole->sensorLabel != soFar_->sensorLabel) {
        return false;
    }
    const std::span packets(whole->scan_packets);
    const std::span first(soFar_->scan_packets);
    return packets.size() >= first.size() &&
           std::ranges::equal(std::as_bytes(packets.first(first.size())), std::as_bytes(first));
}

}  // namespace offmap::live
