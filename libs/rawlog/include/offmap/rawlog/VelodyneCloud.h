// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

#include <mrpt/obs/CObservationVelodyneScan.h>

namespace offmap::rawlog {

/// Filters the point cloud that a Velodyne scan may store beside its packets. Each of its points
/// belongs to the return nearest to it, within 2 cm at 30 m, and stays if that return stays. All
/// vectors of the cloud stay consistent. \param obs still holds all returns in its packets
void filterStoredCloud(mrpt::obs::CObservationVelodyneScan& obs, SlotMask keep,
                       Leftovers leftovers);

}  // namespace offmap::rawlog
