// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// One firing of all 16 lasers.
struct VelodyneFiring {
    double azimuth = 0;              ///< [rad] CCW from the sensor's x axis, at its middle
    mrpt::Clock::time_point time{};  ///< of its first laser
    uint32_t begin = 0, end = 0;     ///< half-open range into VelodyneReturns::points
};

/// The returns of a VLP-16 scan, firing after firing, each in the order of the lasers.
struct VelodyneReturns {
    std::vector<mrpt::math::TPoint3Df> points;  ///< [m] sensor frame: x forward, y left
    std::vector<uint32_t> slots;                ///< per point: 384 a packet, 32 a block
    std::vector<VelodyneFiring> firings;
};

inline constexpr size_t slotsPerPacket = mrpt::obs::CObservationVelodyneScan::SCANS_PER_PACKET;

/// Decodes every firing of the packets; CObservationVelodyneScan::generatePointCloud() leaves out
/// every second one. Ranges outside the observation's minRange, maxRange are returns as well.
/// The azimuth of a return is interpolated by its time, with the packet's median rotation rate;
/// azimuth corrections of the calibration are not applied, nor does MRPT apply them.
VelodyneReturns decodePackets(const mrpt::obs::CObservationVelodyneScan& obs);

/// Return k of the packets, k in [0, packets * slotsPerPacket).
const mrpt::obs::CObservationVelodyneScan::laser_return_t& returnInSlot(
    const mrpt::obs::CObservationVelodyneScan& obs, size_t slot);

/// [2 mm] 0: no return.
uint16_t distanceOf(const mrpt::obs::CObservationVelodyneScan::laser_return_t& laserReturn);

}  // namespace offmap::rawlog
