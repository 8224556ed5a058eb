// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/OccupancyGrid.h>

namespace offmap::maps {

/// Makes groups of fewer occupied cells than that unknown; cells with at most one
/// other between them belong together. \return how many groups
size_t dropSpecks(OccupancyGrid& grid, size_t leastCells);

}  // namespace offmap::maps
