// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/OccupancyGrid.h>

namespace offmap::maps {

/// What a cell is that is free by some chance: MRPT's own ray casting passes what is free by 40 %.
/// The same distance from one half is asked of free ones.
inline Cell cellOfChance(float free) {
    return free < 0.4F ? Cell::Occupied : free > 0.6F ? Cell::Free : Cell::Unknown;
}

}  // namespace offmap::maps
