// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>
#include <offmap/maps/OccupancyGrid.h>

#include <string>

namespace offmap::maps {

/// The walls of a grid, as MapOptions::gridWalls asks for them. \param name stands for the file
/// \throw std::runtime_error if the grid holds no wall that can be seen
Drawing drawingOf(OccupancyGrid grid, const MapOptions& options, const std::string& format,
                  const std::string& name);

/// Adds warnings about options that a grid of known cell size does not take.
void warnOfUnusedOptions(const MapOptions& options, Drawing& drawing);

}  // namespace offmap::maps
