// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/SensorConfig.h>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <chrono>
#include <cstddef>

namespace offmap::rawlog {

/// Median of what the head turns [1/100 deg] from block to block, of those that are `stride` apart.
double medianStep(const mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket& packet,
                  size_t stride);

/// The packet's stamp counts microseconds from the full hour, and starts again at the next.
std::chrono::microseconds sinceFirstPacket(
    const mrpt::obs::CObservationVelodyneScan& obs,
    const mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket& packet);

/// \param reference what the time stamp of the observation tells
mrpt::Clock::time_point timeOfFirstPacket(const mrpt::obs::CObservationVelodyneScan& obs,
                                          TimeReference reference);

}  // namespace offmap::rawlog
