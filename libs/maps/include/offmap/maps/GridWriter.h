// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>
#include <offmap/maps/OccupancyGrid.h>

#include <span>
#include <string>

namespace offmap::maps {

/// An occupancy grid with a margin of 1 m around the walls: cells that a wall passes through are
/// occupied, all others are free. Only walls that the height of 1 m belongs to are drawn.
/// \param resolution [m] of a cell
/// \throw std::runtime_error if there is no such wall, or the grid would have too many cells
OccupancyGrid gridOf(std::span<const core::Wall> walls, double resolution);

/// The bytes of an MRPT .gridmap file; gzipped, those of a .gridmap.gz.
/// \throw std::runtime_error if the grid is turned: such a file cannot say so
std::string gridMapBytes(const OccupancyGrid& grid);

}  // namespace offmap::maps
