// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/VelodynePackets.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/core/reverse_bytes.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace offmap::rawlog {

namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;
using Packet = Scan::TVelodyneRawPacket;
using LaserCalibrations = std::vector<mrpt::obs::VelodyneCalibration::PerLaserCalib>;
using mrpt::math::TPoint3Df;

// Times of the VLP-16 user manual [us].
constexpr double blockPeriod = 110.592;
constexpr double firingPeriod = 55.296;
constexpr double laserPeriod = 2.304;

constexpr size_t lasers = 16;
constexpr size_t firingsPerBlock = Scan::SCANS_PER_BLOCK / lasers;

/// Fields of packets stand at odd addresses, where MRPT's accessors bind references to them.
template <class T>
T field(const void* record, size_t offset) {
    T value;
    std::memcpy(&value, static_cast<const char*>(record) + offset, sizeof value);
    return mrpt::toNativeEndianness(value);
}

uint16_t headerOf(const Scan::raw_block_t& block) { return field<uint16_t>(&block, 0); }
uint16_t rotationOf(const Scan::raw_block_t& block) { return field<uint16_t>(&block, 2); }
uint32_t stampOf(const Packet& packet) { return field<uint32_t>(&packet, sizeof packet.blocks); }

const LaserCalibrations& calibrationOf(const Scan& obs) {
    static const mrpt::obs::VelodyneCalibration factory =
        mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
    const auto& corrections =
        (obs.calibration.empty() ? factory : obs.calibration).laser_corrections;
    if (corrections.size() != lasers) {
        throw std::invalid_argument(
            fmt::format("the Velodyne calibration of '{}' is of {} lasers, but a VLP-16 has 16",
                        obs.sensorLabel, corrections.size()));
    }
    return corrections;
}

/// [1/100 deg] that the head turns in one block period.
double rotationPerBlock(const Packet& packet) {
    std::array<int, Scan::BLOCKS_PER_PACKET - 1> steps{};
    for (size_t i = 0; i < steps.size(); ++i) {
        const int step = rotationOf(packet.blocks[i + 1]) - rotationOf(packet.blocks[i]);
        steps[i] = (step + Scan::ROTATION_MAX_UNITS) % Scan::ROTATION_MAX_UNITS;
    }
    std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
    return steps[steps.size() / 2];
}

/// The packet's stamp counts microseconds from the full hour, and starts again at the next.
std::chrono::microseconds sinceFirstPacket(const Scan& obs, const Packet& packet) {
    constexpr int64_t hour = 3'600'000'000;
    const int64_t first = stampOf(obs.scan_packets.front());
    int64_t elapsed = stampOf(packet) - first;
    if (elapsed <= -hour / 2) elapsed += hour;
    if (elapsed > hour / 2) elapsed -= hour;
    return std::chrono::microseconds(elapsed);
}

/// \param clockwise [rad] azimuth as the sensor counts it
TPoint3Df pointOf(uint16_t distance, double clockwise,
                  const mrpt::obs::VelodyneCalibration::PerLaserCalib& laser) {
    const double range =
        distance * static_cast<double>(Scan::DISTANCE_RESOLUTION) + laser.distanceCorrection;
    const double ground =
        range * laser.cosVertCorrection + laser.verticalOffsetCorrection * laser.sinVertCorrection;
    const double offset = laser.horizontalOffsetCorrection;
    const double c = std::cos(clockwise), s = std::sin(clockwise);
    return {static_cast<float>(ground * c + offset * s),
            static_cast<float>(offset * c - ground * s),
            static_cast<float>(range * laser.sinVertCorrection + laser.verticalOffsetCorrection)};
}

double toRadians(double hundredthsOfDegrees) { return mrpt::DEG2RAD(0.01 * hundredthsOfDegrees); }

class Decoder {
 public:
    explicit Decoder(const Scan& obs) : obs_(obs), lasers_(calibrationOf(obs)) {
        out_.points.reserve(obs.scan_packets.size() * slotsPerPacket);
        out_.slots.reserve(obs.scan_packets.size() * slotsPerPacket);
    }

    VelodyneReturns decode() && {
        for (size_t p = 0; p < obs_.scan_packets.size(); ++p) decodePacket(p);
        return std::move(out_);
    }

 private:
    void decodePacket(size_t p) {
        const Packet& packet = obs_.scan_packets[p];
        const auto packetTime = obs_.timestamp + sinceFirstPacket(obs_, packet);
        const double rate = rotationPerBlock(packet) / blockPeriod;
        for (size_t b = 0; b < Scan::BLOCKS_PER_PACKET; ++b) {
            if (headerOf(packet.blocks[b]) != Scan::UPPER_BANK) continue;  // mangled
            for (size_t f = 0; f < firingsPerBlock; ++f) {
                const double offset =
                    static_cast<double>(b) * blockPeriod + static_cast<double>(f) * firingPeriod;
                const auto sincePacket = std::chrono::duration<double, std::micro>(offset);
                VelodyneFiring firing;
                firing.time =
                    packetTime + std::chrono::duration_cast<mrpt::Clock::duration>(sincePacket);
                const size_t firstSlot =
                    (p * Scan::BLOCKS_PER_PACKET + b) * Scan::SCANS_PER_BLOCK + f * lasers;
                decodeFiring(firing, packet.blocks[b], f, firstSlot, rate);
            }
        }
    }

    /// \param rate [1/100 deg / us]
    void decodeFiring(VelodyneFiring firing, const Scan::raw_block_t& block, size_t f,
                      size_t firstSlot, double rate) {
        const double start =
            rotationOf(block) + rate * firingPeriod * static_cast<double>(f);  // [1/100 deg]
        const double middle = start + rate * laserPeriod * 0.5 * (lasers - 1);
        firing.azimuth = -toRadians(middle);
        firing.begin = static_cast<uint32_t>(out_.points.size());
        for (size_t l = 0; l < lasers; ++l) {
            const uint16_t distance = distanceOf(block.laser_returns[f * lasers + l]);
            if (distance == 0) continue;
            const double clockwise = start + rate * laserPeriod * static_cast<double>(l);
            out_.points.push_back(pointOf(distance, toRadians(clockwise), lasers_[l]));
            out_.slots.push_back(static_cast<uint32_t>(firstSlot + l));
        }
        firing.end = static_cast<uint32_t>(out_.points.size());
        out_.firings.push_back(firing);
    }

    const Scan& obs_;
    const LaserCalibrations& lasers_;
    VelodyneReturns out_;
};

}  // namespace

uint16_t distanceOf(const Scan::laser_return_t& laserReturn) {
    return field<uint16_t>(&laserReturn, 0);
}

VelodyneReturns decodePackets(const Scan& obs) { return Decoder(obs).decode(); }

const Scan::laser_return_t& returnInSlot(const Scan& obs, size_t slot) {
    const size_t block = slot / Scan::SCANS_PER_BLOCK;
    return obs.scan_packets[block / Scan::BLOCKS_PER_PACKET]
        .blocks[block % Scan::BLOCKS_PER_PACKET]
        .laser_returns[slot % Scan::SCANS_PER_BLOCK];
}

}  // namespace offmap::rawlog
