// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/MapBounds.h>

#include <algorithm>

namespace offmap::maps {

core::WallBounds boundsOfAll(std::span<const core::Wall> walls) {
    core::WallBounds all = core::boundsOf(walls.front());
    for (const core::Wall& wall : walls) {
        const core::WallBounds one = core::boundsOf(wall);
        all.low = {std::min(all.low.x, one.low.x), std::min(all.low.y, one.low.y)};
        all.high = {std::max(all.high.x, one.high.x), std::max(all.high.y, one.high.y)};
    }
    return all;
}

}  // namespace offmap::maps
