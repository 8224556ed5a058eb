// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// One firing of all lasers. Where a laser has two returns (dual return mode), equal ones follow
/// each other; the strongest of different ones stands in [second, end).
struct VelodyneFiring {
    double azimuth = 0;              ///< [rad] CCW from the sensor's x axis, at its middle
    mrpt::Clock::time_point time{};  ///< of its first laser
    /// Half-open ranges [begin, second), [second, end) into VelodyneReturns::points.
    uint32_t begin = 0, second = 0, end = 0;
};

/// The returns of a scan, firing after firing, each in the order of the lasers.
struct VelodyneReturns {
    std::vector<mrpt::math::TPoint3Df> points;  ///< [m] sensor frame: x forward, y left
    std::vector<uint32_t> slots;                ///< per point: 384 a packet, 32 a block
    std::vector<uint8_t> lasers;                ///< per point: its laser, in firing order
    std::vector<uint8_t> upward;                ///< the lasers, from the one that looks lowest
    std::vector<VelodyneFiring> firings;
    /// Per laser: [rad] CCW from its firing's azimuth to where it looks; empty if all look there.
    std::vector<double> azimuthCorrections;
};

struct VelodyneDecoding {
    TimeReference timeReference = TimeReference::First;  ///< of the observation: which packet
    bool correctAzimuth = true;  ///< apply the azimuth corrections of the calibration
};

inline constexpr size_t slotsPerPacket = mrpt::obs::CObservationVelodyneScan::SCANS_PER_PACKET;

/// Decodes every firing of the packets; CObservationVelodyneScan::generatePointCloud() leaves out
/// half of the lasers or firings, and azimuth corrections. Ranges outside the observation's
/// minRange, maxRange are returns as well; a block with a mangled header or rotation holds none.
/// The azimuth of a return is interpolated by its time, with the packet's median rotation rate.
/// \throw std::invalid_argument for what unsupportedVelodyne() refuses
VelodyneReturns decodePackets(const mrpt::obs::CObservationVelodyneScan& obs,
                              const VelodyneDecoding& decoding = {});

/// The same from one packet on, behind what those before were decoded to. The time stamp has to be
/// that of the first packet, as long as packets may come.
void decodeFurther(const mrpt::obs::CObservationVelodyneScan& obs, size_t firstPacket,
                   const VelodyneDecoding& decoding, VelodyneReturns& out);

/// Return k of the packets, k in [0, packets * slotsPerPacket).
const mrpt::obs::CObservationVelodyneScan::laser_return_t& returnInSlot(
    const mrpt::obs::CObservationVelodyneScan& obs, size_t slot);

/// [2 mm] 0: no return.
uint16_t distanceOf(const mrpt::obs::CObservationVelodyneScan::laser_return_t& laserReturn);

}  // namespace offmap::rawlog
