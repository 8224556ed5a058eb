// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace offmap::rawlog {

/// Whether CObservationRotatingScan::lidarModel is a name that MRPT gives to what it converts from
/// Velodyne packets.
bool isVelodyneModel(std::string_view lidarModel);

/// Elevations [rad] of the rows of a range image, row 0 first, as far as the model's name tells:
/// those of a Velodyne stand in the order in which its lasers fire. Empty if it does not.
std::vector<double> elevationsOfModel(std::string_view lidarModel);

}  // namespace offmap::rawlog
