// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/bits_math.h>
#include <mrpt/core/reverse_bytes.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdint>
#include <cstring>

namespace offmap::rawlog {

/// Fields of packets stand at odd addresses, where MRPT's accessors bind references to them.
template <class T>
T field(const void* record, size_t offset) {
    T value;
    std::memcpy(&value, static_cast<const char*>(record) + offset, sizeof value);
    return mrpt::toNativeEndianness(value);
}

inline uint16_t headerOf(const mrpt::obs::CObservationVelodyneScan::raw_block_t& block) {
    return field<uint16_t>(&block, 0);
}

/// [1/100 deg] clockwise
inline uint16_t rotationOf(const mrpt::obs::CObservationVelodyneScan::raw_block_t& block) {
    return field<uint16_t>(&block, 2);
}

inline double toRadians(double hundredthsOfDegrees) {
    return mrpt::DEG2RAD(0.01 * hundredthsOfDegrees);
}

/// [us] from the full hour
inline uint32_t stampOf(const mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket& packet) {
    return field<uint32_t>(&packet, sizeof packet.blocks);
}

}  // namespace offmap::rawlog
