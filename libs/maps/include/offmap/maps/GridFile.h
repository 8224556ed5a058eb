// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>
#include <offmap/maps/OccupancyGrid.h>

#include <filesystem>

namespace offmap::maps {

/// An MRPT .gridmap or .gridmap.gz. Occupied and free are cells that MRPT's own ray casting takes
/// for that: below 40 and above 60 % free.
/// \throw std::runtime_error naming the file and what is wrong with it
OccupancyGrid readGridMap(const std::filesystem::path& file);

Drawing readGridMapDrawing(const std::filesystem::path& file, const MapOptions& options);

}  // namespace offmap::maps
