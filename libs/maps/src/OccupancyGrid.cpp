// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/OccupancyGrid.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace offmap::maps {

OccupancyGrid makeGrid(uint64_t width, uint64_t height, double resolution, Cell fill,
                       const std::string& name) {
    // 500 m x 500 m in cells of 5 cm; each takes some bytes on the way to walls.
    constexpr uint64_t maxCells = 100'000'000;
    if (width == 0 || height == 0) {
        throw std::runtime_error(
            fmt::format("{}: the grid is empty, {} x {} cells", name, width, height));
    }
    if (width > maxCells || height > maxCells || width * height > maxCells) {
        throw std::runtime_error(
            fmt::format("{}: the grid has {} x {} cells, more than {}; cut out what is needed, or "
                        "take larger cells",
                        name, width, height, maxCells));
    }
    if (!(resolution > 0) || !std::isfinite(resolution)) {
        throw std::runtime_error(
            fmt::format("{}: the resolution is {}, but it has to be above 0, in metres of a cell",
                        name, resolution));
    }
    OccupancyGrid grid;
    grid.width = static_cast<int>(width);
    grid.height = static_cast<int>(height);
    grid.resolution = resolution;
    grid.cells.assign(width * height, fill);
    return grid;
}

}  // namespace offmap::maps
