// SPDX-License-Identifier: BSD-3-Clause
#include "PacketTimes.h"

#include "VelodyneFields.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace offmap::rawlog {

using Scan = mrpt::obs::CObservationVelodyneScan;
using Packet = Scan::TVelodyneRawPacket;

double medianStep(const Packet& packet, size_t stride) {
    std::vector<int> steps;
    for (size_t i = 0; i + stride < size_t{Scan::BLOCKS_PER_PACKET}; ++i) {
        const int step = rotationOf(packet.blocks[i + stride]) - rotationOf(packet.blocks[i]);
        steps.push_back((step + 2 * Scan::ROTATION_MAX_UNITS) % Scan::ROTATION_MAX_UNITS);
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

std::chrono::microseconds sinceFirstPacket(const Scan& obs, const Packet& packet) {
    constexpr int64_t hour = 3'600'000'000;
    const int64_t first = stampOf(obs.scan_packets.front());
    int64_t elapsed = stampOf(packet) - first;
    if (elapsed <= -hour / 2) elapsed += hour;
    if (elapsed > hour / 2) elapsed -= hour;
    return std::chrono::microseconds(elapsed);
}

mrpt::Clock::time_point timeOfFirstPacket(const Scan& obs, TimeReference reference) {
    if (reference == TimeReference::First || obs.scan_packets.empty()) return obs.timestamp;
    const auto lasted = sinceFirstPacket(obs, obs.scan_packets.back());
    return obs.timestamp - (reference == TimeReference::Last ? lasted : lasted / 2);
}

}  // namespace offmap::rawlog
