// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/WallPlacement.h>

namespace offmap::maps {

std::vector<core::Wall> placed(std::vector<core::Wall> walls, const mrpt::poses::CPose2D& mapOrigin,
                               double scale) {
    for (core::Wall& wall : walls) {
        const mrpt::math::TSegment2D line = wall.line;
        mapOrigin.composePoint(line.point1 * scale, wall.line.point1);
        mapOrigin.composePoint(line.point2 * scale, wall.line.point2);
        wall.curvature /= scale;
    }
    return walls;
}

}  // namespace offmap::maps
