// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/OccupancyGrid.h>

#include <string>
#include <string_view>

namespace offmap::maps {

/// The picture of a ROS map, a binary PGM: occupied cells black, free ones nearly white, unknown
/// ones grey, as ROS's map_saver writes them.
std::string rosPictureOf(const OccupancyGrid& grid);

/// The map.yaml beside it. \param picture its file name, UTF-8
std::string rosYamlOf(const OccupancyGrid& grid, std::string_view picture);

}  // namespace offmap::maps
