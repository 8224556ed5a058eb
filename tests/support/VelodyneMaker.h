// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/bits_math.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

namespace offmap::test {

using VelodynePacket = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;

inline constexpr size_t velodyneBlockBytes = mrpt::obs::CObservationVelodyneScan::SIZE_BLOCK;
inline constexpr uint16_t upperBank = 0xeeff, lowerBank = 0xddff;

template <class T>
void putBytes(VelodynePacket& packet, size_t offset, T value) {
    std::memcpy(reinterpret_cast<char*>(&packet) + offset, &value, sizeof value);
}

inline void setHeader(VelodynePacket& packet, size_t block, uint16_t header) {
    putBytes(packet, block * velodyneBlockBytes, header);
}

/// \param rotation [1/100 deg] clockwise
inline void setRotation(VelodynePacket& packet, size_t block, int rotation) {
    putBytes(packet, block * velodyneBlockBytes + 2, static_cast<uint16_t>(rotation % 36000));
}

/// \param distance [2 mm]
inline void setReturn(VelodynePacket& packet, size_t block, size_t slot, uint16_t distance,
                      uint8_t intensity) {
    const size_t offset = block * velodyneBlockBytes + 4 + slot * 3;
    putBytes(packet, offset, distance);
    putBytes(packet, offset + 2, intensity);
}

/// A strongest-return packet of a VLP-16 without returns. \param stamp [us] from the full hour
inline VelodynePacket emptyVlp16Packet(uint32_t stamp) {
    VelodynePacket packet{};
    for (size_t b = 0; b < 12; ++b) setHeader(packet, b, upperBank);
    putBytes<uint32_t>(packet, 12 * velodyneBlockBytes, stamp);
    packet.laser_return_mode = 0x37;
    packet.velodyne_model_ID = 0x22;
    return packet;
}

inline VelodynePacket emptyHdl32Packet(uint32_t stamp) {
    VelodynePacket packet = emptyVlp16Packet(stamp);
    packet.velodyne_model_ID = 0x21;
    return packet;
}

/// Its last two bytes hold a status: here the temperature, 0x22 degrees.
inline VelodynePacket emptyHdl64Packet(uint32_t stamp) {
    VelodynePacket packet = emptyVlp16Packet(stamp);
    for (size_t b = 1; b < 12; b += 2) setHeader(packet, b, lowerBank);
    packet.laser_return_mode = 'T';
    return packet;
}

/// 64 lasers, 2 degrees above to 24 below the horizon, in four groups that look up to 4.5 degrees
/// to the side.
inline mrpt::obs::VelodyneCalibration hdl64Calibration() {
    mrpt::obs::VelodyneCalibration calibration;
    calibration.laser_corrections.resize(64);
    for (size_t l = 0; l < 64; ++l) {
        auto& laser = calibration.laser_corrections[l];
        const double row = static_cast<double>(l);
        laser.verticalCorrection = l < 32 ? 2 - row / 3 : -8.83 - 0.5 * (row - 32);
        laser.sinVertCorrection = std::sin(mrpt::DEG2RAD(laser.verticalCorrection));
        laser.cosVertCorrection = std::cos(mrpt::DEG2RAD(laser.verticalCorrection));
        laser.azimuthCorrection = 3.0 * static_cast<double>(l % 4) - 4.5;
        laser.distanceCorrection = 0.05 * static_cast<double>(l % 3);
    }
    return calibration;
}

/// How a simulated Velodyne fires and fills its packets.
struct VelodynePlan {
    VelodynePacket (*emptyPacket)(uint32_t stamp);
    size_t packetsPerTurn;
    double blockPeriod;  ///< [us] between blocks of different rotation
    double laserPeriod;  ///< [us] 0: all at once
    size_t firingsPerBlock = 1;
    bool twoBanks = false;  ///< the odd blocks hold lasers 32 to 63 of the same firing
    bool dual = false;      ///< the odd blocks hold the strongest returns

    size_t blocksPerRotation() const { return twoBanks || dual ? 2 : 1; }
    /// [us]
    double packetPeriod() const {
        return 12.0 / static_cast<double>(blocksPerRotation()) * blockPeriod;
    }
};

inline constexpr VelodynePlan vlp16Plan{emptyVlp16Packet, 75, 110.592, 2.304, 2};
inline constexpr VelodynePlan vlp16DualPlan{emptyVlp16Packet, 150, 110.592, 2.304, 2, false, true};
inline constexpr VelodynePlan hdl32Plan{emptyHdl32Packet, 180, 46.08, 1.152};
inline constexpr VelodynePlan hdl64Plan{emptyHdl64Packet, 348, 48, 0, 1, true};

/// [m] What a laser measures so many seconds after the first, along a unit vector in the frame of
/// the sensor; 0: no return.
using LaserRange = std::function<double(double seconds, const mrpt::math::TVector3D& beam)>;

/// Fires the lasers of one block. \param late [us] of the block, after the first packet
/// \param rate [1/100 deg / us]
inline void fireBlock(VelodynePacket& packet, size_t block, const VelodynePlan& plan, double late,
                      double rate, const mrpt::obs::VelodyneCalibration& calibration,
                      const LaserRange& range) {
    const size_t lasers = 32 / plan.firingsPerBlock;
    const size_t firstLaser = plan.twoBanks && block % 2 == 1 ? 32 : 0;
    const double firingPeriod = plan.blockPeriod / static_cast<double>(plan.firingsPerBlock);
    const int rotation = static_cast<int>(std::lround(rate * late));
    for (size_t slot = 0; slot < 32; ++slot) {
        const auto& laser = calibration.laser_corrections.at(firstLaser + slot % lasers);
        const double inBlock = static_cast<double>(slot % lasers) * plan.laserPeriod +
                               static_cast<double>(slot / lasers) * firingPeriod;
        const double azimuth =
            mrpt::DEG2RAD(laser.azimuthCorrection - 0.01 * (rotation + rate * inBlock));
        const double c = laser.cosVertCorrection;
        const double measured =
            range(1e-6 * (late + inBlock),
                  {c * std::cos(azimuth), c * std::sin(azimuth), laser.sinVertCorrection}) -
            laser.distanceCorrection;
        const auto distance = std::lround(std::max(0.0, measured) / 0.002);
        setReturn(packet, block, slot, static_cast<uint16_t>(distance),
                  static_cast<uint8_t>(10 + slot));
    }
}

/// Repeats the block before, at a share of its ranges.
inline void repeatBlock(VelodynePacket& packet, size_t block, double share) {
    for (size_t slot = 0; slot < 32; ++slot) {
        const auto& first = packet.blocks[block - 1].laser_returns[slot];
        setReturn(packet, block, slot, static_cast<uint16_t>(std::lround(share * first.distance())),
                  first.intensity());
    }
}

/// Fills a scan with packets. In dual mode the odd blocks repeat the even ones, but in every fifth
/// pair, where they hold something nearer, at 3/5 of the range.
inline void fireVelodyne(mrpt::obs::CObservationVelodyneScan& scan, const VelodynePlan& plan,
                         size_t packets, const LaserRange& range) {
    const double period = plan.packetPeriod();
    const double rate = 36000.0 / (static_cast<double>(plan.packetsPerTurn) * period);
    for (size_t p = 0; p < packets; ++p) {
        const double start = static_cast<double>(p) * period;
        VelodynePacket packet = plan.emptyPacket(static_cast<uint32_t>(std::lround(start)));
        if (plan.dual) packet.laser_return_mode = 0x39;
        for (size_t b = 0; b < 12; ++b) {
            const size_t turned = b / plan.blocksPerRotation();
            const double late = start + static_cast<double>(turned) * plan.blockPeriod;
            setRotation(packet, b, static_cast<int>(std::lround(rate * late)));
            if (plan.dual && b % 2 == 1) {
                repeatBlock(packet, b, turned % 5 == 0 ? 0.6 : 1);
            } else {
                fireBlock(packet, b, plan, late, rate, scan.calibration, range);
            }
        }
        scan.scan_packets.push_back(packet);
    }
}

}  // namespace offmap::test
