// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/GridDrawing.h>
#include <offmap/maps/GridLines.h>
#include <offmap/maps/Specks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace offmap::maps {

namespace {

using mrpt::math::TSegment2D;

size_t count(const OccupancyGrid& grid, Cell cell) {
    return static_cast<size_t>(std::ranges::count(grid.cells, cell));
}

void requireWalls(const OccupancyGrid& grid, const std::string& name) {
    if (count(grid, Cell::Occupied) > 0) return;
    throw std::runtime_error(fmt::format(
        "{}: the grid holds no wall: of {} x {} cells {} are free, the others unknown; are its "
        "thresholds right, or is it inverted?",
        name, grid.width, grid.height, count(grid, Cell::Free)));
}

void tellOfCells(OccupancyGrid& grid, Drawing& drawing) {
    if (2 * count(grid, Cell::Occupied) > grid.cells.size()) {
        drawing.warnings.emplace_back(
            "more than half of the grid is occupied: is it inverted? Dark cells are walls");
    }
    if (count(grid, Cell::Free) > 0) return;
    std::ranges::replace(grid.cells, Cell::Unknown, Cell::Free);
    drawing.notes.emplace_back("grid: no cell is free, so unknown ones are taken for free");
}

std::vector<TSegment2D> linesOf(OccupancyGrid& grid, const MapOptions& options, Drawing& drawing) {
    if (options.gridWalls == GridWalls::Cells) return gridFaceLines(grid);
    constexpr size_t leastCells = 4;
    if (const size_t specks = dropSpecks(grid, leastCells); specks > 0) {
        drawing.notes.push_back(fmt::format("grid: {} speck{} of fewer than {} cells left out",
                                            specks, specks == 1 ? "" : "s", leastCells));
    }
    return gridLines(grid, ThinWall::Middle);
}

core::Wall wallOf(const TSegment2D& line, const OccupancyGrid& grid, double sigma) {
    core::Wall wall;
    grid.origin.composePoint(line.point1 * grid.resolution, wall.line.point1);
    grid.origin.composePoint(line.point2 * grid.resolution, wall.line.point2);
    // A surface stands anywhere in its cell: the deviation of a uniform distribution.
    wall.sigma = std::sqrt(sigma * sigma + grid.resolution * grid.resolution / 12);
    return wall;
}

}  // namespace

Drawing drawingOf(OccupancyGrid grid, const MapOptions& options, const std::string& format,
                  const std::string& name) {
    requireWalls(grid, name);
    Drawing drawing;
    drawing.format = format;
    drawing.notes.push_back(
        fmt::format("grid: {} x {} cells of {:g} m", grid.width, grid.height, grid.resolution));
    tellOfCells(grid, drawing);
    const uint32_t layer = drawing.layer("");
    for (const TSegment2D& line : linesOf(grid, options, drawing)) {
        drawing.add(wallOf(line, grid, options.sigma), layer);
    }
    if (drawing.walls.empty()) {
        throw std::runtime_error(
            fmt::format("{}: the grid holds no wall: no free cell lies before a group of 4 or more "
                        "occupied ones; --map-as grid takes every occupied cell",
                        name));
    }
    return drawing;
}

void warnOfUnusedOptions(const MapOptions& options, Drawing& drawing) {
    if (options.resolution) {
        drawing.warnings.emplace_back(
            "--map-resolution is not used: the grid states the size of its cells; --map-scale "
            "would change it");
    }
}

}  // namespace offmap::maps
