// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/LogFiles.h"
#include "../support/VelodyneMaker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace offmap::test {

/// [2 mm] The ranges of a packet in the order they stand in it.
inline std::vector<uint16_t> rangesOf(const VelodynePacket& packet) {
    std::vector<uint16_t> ranges;
    const auto* bytes = reinterpret_cast<const char*>(&packet);
    for (size_t block = 0; block < 12; ++block) {
        for (size_t slot = 0; slot < 32; ++slot) {
            uint16_t range = 0;
            std::memcpy(&range, bytes + block * velodyneBlockBytes + 4 + 3 * slot, sizeof range);
            ranges.push_back(range);
        }
    }
    return ranges;
}

/// The packets of a real VLP-16's turn, over and over, as if it had gone on turning: the stamps go
/// on at the sensor's rate, the azimuths by 1/75 of a turn each packet.
class VelodyneStream {
 public:
    static constexpr double period = 1327.104;  // [us] from packet to packet

    VelodyneStream() {
        const auto log = observationsOf("/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog");
        const auto scan =
            std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(log.front());
        packets_ = scan->scan_packets;
        std::memcpy(&first_, reinterpret_cast<const char*>(packets_.data()) + 2, sizeof first_);
    }

    size_t packetsPerTurn() const { return packets_.size(); }

    /// Packet number n since the stream began.
    VelodynePacket packet(uint64_t n) const {
        VelodynePacket packet = packets_[n % packets_.size()];
        const double stamp = std::fmod(static_cast<double>(n) * period, 3.6e9);  // of the hour
        putBytes(packet, blocks * velodyneBlockBytes, static_cast<uint32_t>(stamp));
        for (size_t block = 0; block < blocks; ++block) {
            putBytes(packet, block * velodyneBlockBytes + 2, rotation(n, block));
        }
        return packet;
    }

    /// That so many packets from the first one on make: the first begins somewhere on the circle,
    /// the last may be cut short.
    uint64_t turnsOf(uint64_t packets) const {
        uint64_t turns = 0;
        for (uint64_t n = 0; n < packets; ++n) turns += n == 0 || rotation(n) < rotation(n - 1);
        return turns;
    }

    /// Of packet n, that it holds.
    size_t returns(uint64_t n) const {
        const auto ranges = rangesOf(packets_[n % packets_.size()]);
        return ranges.size() - static_cast<size_t>(std::count(ranges.begin(), ranges.end(), 0));
    }

 private:
    static constexpr uint64_t circle = 36000;  // [1/100 deg]
    static constexpr size_t blocks = 12;       // of a packet

    /// [1/100 deg] clockwise
    uint16_t rotation(uint64_t n, size_t block = 0) const {
        const uint64_t perTurn = blocks * packets_.size();
        const uint64_t gone = (n * blocks + block) % perTurn;
        return static_cast<uint16_t>((first_ + gone * circle / perTurn) % circle);
    }

    std::vector<VelodynePacket> packets_;
    uint16_t first_ = 0;  // [1/100 deg] the first packet's rotation
};

}  // namespace offmap::test
