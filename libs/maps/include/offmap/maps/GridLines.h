// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/OccupancyGrid.h>

#include <mrpt/math/TSegment2D.h>

#include <vector>

namespace offmap::maps {

/// Where the surface of a wall stands that is a cell thick.
enum class ThinWall : uint8_t {
    Middle,  ///< one line, in the middle of its cells
    Faces,   ///< as of thick walls: a line along each side that can be seen
};

/// Straight lines along the faces of occupied cells that can be seen: those with a free cell before
/// them, or behind at most two that are unknown. Each line is within half a cell of the middles of
/// the faces it stands for, and within a cell of any occupied cell that can be seen there is a
/// line. In cells, from the grid's lower left corner.
std::vector<mrpt::math::TSegment2D> gridLines(const OccupancyGrid& grid, ThinWall thin);

/// All faces of occupied cells, merged along rows and columns: a ray from a free cell ends on one
/// of them where an exact traversal of the grid ends. In cells, from the grid's lower left corner.
std::vector<mrpt::math::TSegment2D> gridFaceLines(const OccupancyGrid& grid);

}  // namespace offmap::maps
