// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/SimulatedRobot.h"

#include <offmap/rawlog/ScanClass.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

namespace offmap::test {

using VelodyneObservation = mrpt::obs::CObservationVelodyneScan;

/// The turn as it is when so many packets have come.
inline rawlog::Turn firstPackets(const VelodyneObservation& whole, size_t packets) {
    auto part = std::make_shared<VelodyneObservation>(whole);
    part->scan_packets.resize(packets);
    return {part};
}

/// How many packets there are after each piece: pieces of 1 to 20 packets; not all of the turn.
inline std::vector<size_t> randomPieces(size_t packets, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<size_t> size(1, 20);
    std::vector<size_t> ends;
    for (size_t end = size(random); end < packets; end += size(random)) ends.push_back(end);
    return ends;
}

/// Turns of a robot that turns on the spot at 40 degrees a second, one of each way to stream.
inline std::vector<std::shared_ptr<VelodyneObservation>> velodyneTurns() {
    SimulatedRobot robot;
    robot.yawRate = mrpt::DEG2RAD(40.0);
    return {robot.vlp16(), robot.vlp16Dual(), robot.hdl32(), robot.hdl64(60)};
}

/// Where that robot is.
inline mrpt::poses::CPose3D turningPose(mrpt::Clock::time_point time) {
    const double passed = std::chrono::duration<double>(time - SimulatedRobot().now).count();
    return SimulatedRobot().pose +
           mrpt::poses::CPose3D(0, 0, 0, mrpt::DEG2RAD(40.0) * passed, 0, 0);
}

}  // namespace offmap::test
