// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/LogFiles.h"
#include "../support/VelodyneMaker.h"

#include <cmath>
#include <vector>

namespace offmap::test {

/// The packets of a real VLP-16's turn, over and over, as if it had gone on turning: the stamps go
/// on at the sensor's rate.
class VelodyneStream {
 public:
    static constexpr double period = 1327.104;  // [us] from packet to packet

    VelodyneStream() {
        const auto log = observationsOf("/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog");
        const auto scan =
            std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(log.front());
        packets_ = scan->scan_packets;
    }

    size_t packetsPerTurn() const { return packets_.size(); }

    /// Packet number n since the stream began.
    VelodynePacket packet(uint64_t n) const {
        VelodynePacket packet = packets_[n % packets_.size()];
        const double stamp = std::fmod(static_cast<double>(n) * period, 3.6e9);  // of the hour
        putBytes(packet, 12 * velodyneBlockBytes, static_cast<uint32_t>(stamp));
        return packet;
    }

 private:
    std::vector<VelodynePacket> packets_;
};

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

}  // namespace offmap::test
