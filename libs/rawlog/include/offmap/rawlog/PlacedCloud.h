// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/CloudPoints.h>
#include <offmap/rawlog/PoseSource.h>
#include <offmap/rawlog/ScanClass.h>

#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>

namespace offmap::rawlog {

/// A cloud of points in memory, in any order, all taken from one place: compensated for movement.
struct PlacedCloud {
    CloudPoints points;  ///< [m] sensor frame
    mrpt::Clock::time_point time{};
    PoseLookup vehicle;
    mrpt::poses::CPose3D sensorInVehicle;
};

/// Puts the columns of a cloud, by azimuth in the sensor's frame, behind those that `out` has.
/// \param firstSlot the slot of the cloud's first point; every point has one
void appendCloud(TurnScan& out, const PlacedCloud& cloud, uint32_t firstSlot,
                 const SensorConfig& config);

}  // namespace offmap::rawlog
