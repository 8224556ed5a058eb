// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstring>

namespace offmap::test {

using VelodynePacket = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;

inline constexpr size_t velodyneBlockBytes = mrpt::obs::CObservationVelodyneScan::SIZE_BLOCK;

template <class T>
void putBytes(VelodynePacket& packet, size_t offset, T value) {
    std::memcpy(reinterpret_cast<char*>(&packet) + offset, &value, sizeof value);
}

/// A strongest-return packet of a VLP-16 without returns. \param stamp [us] from the full hour
inline VelodynePacket emptyVlp16Packet(uint32_t stamp) {
    VelodynePacket packet{};
    for (size_t b = 0; b < 12; ++b) putBytes<uint16_t>(packet, b * velodyneBlockBytes, 0xeeff);
    putBytes<uint32_t>(packet, 12 * velodyneBlockBytes, stamp);
    packet.laser_return_mode = 0x37;
    packet.velodyne_model_ID = 0x22;
    return packet;
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

}  // namespace offmap::test
