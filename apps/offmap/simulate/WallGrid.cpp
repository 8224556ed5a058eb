// SPDX-License-Identifier: BSD-3-Clause
#include "WallGrid.h"

#include <offmap/core/WallGeometry.h>

#include <algorithm>
#include <cmath>

namespace offmap::app {

namespace {

using mrpt::math::TPoint2D;

constexpr double margin = 1;      // [m]
constexpr double planHeight = 1;  // [m] at which the plan cuts the walls

mrpt::maps::COccupancyGridMap2D emptyGrid(std::span<const core::Wall> walls, double resolution) {
    TPoint2D low = walls.front().line.point1, high = low;
    for (const core::Wall& wall : walls) {
        const core::WallBounds bounds = core::boundsOf(wall);
        low = {std::min(low.x, bounds.low.x), std::min(low.y, bounds.low.y)};
        high = {std::max(high.x, bounds.high.x), std::max(high.y, bounds.high.y)};
    }
    const auto f = [](double value) { return static_cast<float>(value); };
    mrpt::maps::COccupancyGridMap2D grid(f(low.x - margin), f(high.x + margin), f(low.y - margin),
                                         f(high.y + margin), f(resolution));
    grid.fill(1);
    return grid;
}

/// Every cell that the wall passes through: no ray may slip between two that touch at a corner
/// only. Steps of a tenth of a cell leave out no more than such a corner's tip; the cells beside
/// each diagonal step are drawn as well.
void draw(mrpt::maps::COccupancyGridMap2D& grid, const core::Wall& wall) {
    const double steps =
        std::ceil(10 * core::lengthOf(wall) / static_cast<double>(grid.getResolution()));
    int lastX = grid.x2idx(wall.line.point1.x), lastY = grid.y2idx(wall.line.point1.y);
    for (double i = 0; i <= steps; ++i) {
        const TPoint2D p = core::placeAt(wall, i / steps);
        const int x = grid.x2idx(p.x), y = grid.y2idx(p.y);
        if (x != lastX && y != lastY) grid.setCell(x, lastY, 0);
        grid.setCell(x, y, 0);
        lastX = x;
        lastY = y;
    }
}

}  // namespace

mrpt::maps::COccupancyGridMap2D gridOf(std::span<const core::Wall> walls, double resolution) {
    auto grid = emptyGrid(walls, resolution);
    for (const core::Wall& wall : walls) {
        if (wall.height.contains(planHeight)) draw(grid, wall);
    }
    return grid;
}

}  // namespace offmap::app
