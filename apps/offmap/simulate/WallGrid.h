// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <span>

namespace offmap::app {

/// An occupancy grid with a margin of 1 m around the walls: cells that a wall passes through are
/// occupied, all others are free. Only walls that the height of 1 m belongs to are drawn.
/// \param resolution [m] of a cell \pre there is a wall
mrpt::maps::COccupancyGridMap2D gridOf(std::span<const core::Wall> walls, double resolution);

}  // namespace offmap::app
