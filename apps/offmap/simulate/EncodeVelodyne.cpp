// SPDX-License-Identifier: BSD-3-Clause
#include "EncodedScan.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace offmap::app {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;
using Packet = Scan::TVelodyneRawPacket;

constexpr size_t lasers = 16;
constexpr size_t firingsPerBlock = Scan::SCANS_PER_BLOCK / lasers;
constexpr size_t firingsPerPacket = firingsPerBlock * Scan::BLOCKS_PER_PACKET;
constexpr double packetPeriod = 1327.104;  // [us]
constexpr uint8_t vlp16Id = 0x22;

/// The fields of MRPT's packets are private. A packet is little-endian, as is Debian's amd64.
template <class T>
void put(Packet& packet, size_t offset, T value) {
    static_assert(sizeof(Packet) == Scan::PACKET_SIZE);
    std::memcpy(reinterpret_cast<char*>(&packet) + offset, &value, sizeof value);
}

/// [us] from the full hour
uint32_t stampOf(mrpt::Clock::time_point start, size_t packet) {
    using std::chrono::microseconds;
    constexpr int64_t hour = 3'600'000'000;
    const auto first = std::chrono::duration_cast<microseconds>(start.time_since_epoch()).count();
    const auto late = std::lround(packetPeriod * static_cast<double>(packet));
    return static_cast<uint32_t>((first + late) % hour);
}

/// [1/100 deg] clockwise, [0, 36000)
uint16_t rotationOf(double azimuth) {
    const auto turned = std::lround(-100 * mrpt::RAD2DEG(azimuth));
    return static_cast<uint16_t>((turned + Scan::ROTATION_MAX_UNITS) % Scan::ROTATION_MAX_UNITS);
}

/// Per laser, in firing order: which ring it is, counted from the lowest.
std::vector<size_t> ringsOf(const mrpt::obs::VelodyneCalibration& calibration) {
    const auto& corrections = calibration.laser_corrections;
    std::vector<size_t> rings;
    for (const auto& laser : corrections) {
        rings.push_back(static_cast<size_t>(std::ranges::count_if(corrections, [&](const auto& l) {
            return l.verticalCorrection < laser.verticalCorrection;
        })));
    }
    return rings;
}

class PacketWriter {
 public:
    PacketWriter(const evaluation::SimulatedScan& scan, const LogSensor& sensor, Scan& obs)
        : scan_(scan),
          sensor_(sensor),
          points_(scan, sensor.scanner),
          rings_(ringsOf(obs.calibration)),
          obs_(obs) {}

    std::vector<EncodedReturn> write() && {
        const size_t packets = sensor_.scanner.azimuths.size() / firingsPerPacket;
        for (size_t p = 0; p < packets; ++p) {
            Packet packet{};
            packet.laser_return_mode = Scan::RETMODE_STRONGEST;
            packet.velodyne_model_ID = vlp16Id;
            put(packet, Scan::BLOCKS_PER_PACKET * Scan::SIZE_BLOCK, stampOf(obs_.timestamp, p));
            for (size_t b = 0; b < Scan::BLOCKS_PER_PACKET; ++b) writeBlock(packet, p, b);
            obs_.scan_packets.push_back(packet);
        }
        return std::move(returns_);
    }

 private:
    void writeBlock(Packet& packet, size_t packetIndex, size_t block) {
        const size_t start = block * Scan::SIZE_BLOCK;
        const size_t firing = packetIndex * firingsPerPacket + block * firingsPerBlock;
        put(packet, start, Scan::UPPER_BANK);
        put(packet, start + 2, rotationOf(sensor_.scanner.azimuths[firing]));
        for (size_t k = 0; k < Scan::SCANS_PER_BLOCK; ++k) {
            const auto point = points_.at(firing + k / lasers, rings_[k % lasers]);
            if (!point) continue;
            const auto distance = std::lround(rangeOf(scan_, *point) / distanceStep);
            if (distance < 1 || distance > std::numeric_limits<uint16_t>::max()) continue;
            put(packet, start + 4 + 3 * k, static_cast<uint16_t>(distance));
            put(packet, start + 4 + 3 * k + 2, eightBits(intensityOf(scan_, *point)));
            const size_t slot =
                (packetIndex * Scan::BLOCKS_PER_PACKET + block) * Scan::SCANS_PER_BLOCK + k;
            returns_.push_back({static_cast<uint32_t>(slot), *point});
        }
    }

    static constexpr double distanceStep = 0.002;  // [m]

    const evaluation::SimulatedScan& scan_;
    const LogSensor& sensor_;
    PointsByBeam points_;
    std::vector<size_t> rings_;
    Scan& obs_;
    std::vector<EncodedReturn> returns_;
};

}  // namespace

std::vector<EncodedObservation> encodeVelodyne(const evaluation::SimulatedScan& scan,
                                               const LogSensor& sensor) {
    auto obs = Scan::Create();
    obs->sensorLabel = sensor.label;
    obs->sensorPose = sensor.mounting;
    obs->timestamp = scan.scan.columns.front().time;
    obs->minRange = 0;
    obs->maxRange = sensor.scanner.maxRange;
    obs->calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
    auto returns = PacketWriter(scan, sensor, *obs).write();
    return {{obs, std::move(returns)}};
}

}  // namespace offmap::app
