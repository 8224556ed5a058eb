// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/maps/GridWriter.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace offmap::maps {

namespace {

using mrpt::math::TPoint2D;

constexpr double margin = 1;      // [m]
constexpr double planHeight = 1;  // [m] at which the plan cuts the walls

bool isDrawn(const core::Wall& wall) { return wall.height.contains(planHeight); }

OccupancyGrid emptyGrid(std::span<const core::Wall> walls, double resolution) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    TPoint2D low{endless, endless}, high{-endless, -endless};
    for (const core::Wall& wall : walls) {
        if (!isDrawn(wall)) continue;
        const core::WallBounds bounds = core::boundsOf(wall);
        low = {std::min(low.x, bounds.low.x), std::min(low.y, bounds.low.y)};
        high = {std::max(high.x, bounds.high.x), std::max(high.y, bounds.high.y)};
    }
    if (low.x > high.x) throw std::runtime_error("no wall of the map is 1 m high: an empty grid");
    // Corners on whole cells, as MRPT has them.
    const auto cells = [&](double value) { return std::round(value / resolution); };
    const double x = cells(low.x - margin), y = cells(low.y - margin);
    const auto count = [](double value) {
        return static_cast<uint64_t>(std::clamp(value, 0.0, 1e15));
    };
    auto grid = makeGrid(count(cells(high.x + margin) - x), count(cells(high.y + margin) - y),
                         resolution, Cell::Free, "the grid of the map");
    grid.origin = {x * resolution, y * resolution, 0};
    return grid;
}

/// Every cell that the wall passes through: no ray may slip between two that touch at a corner
/// only. Steps of a tenth of a cell leave out no more than such a corner's tip; the cells beside
/// each diagonal step are drawn as well.
void draw(OccupancyGrid& grid, const core::Wall& wall) {
    const auto column = [&](const TPoint2D& p) {
        return static_cast<int>(std::floor((p.x - grid.origin.x()) / grid.resolution));
    };
    const auto row = [&](const TPoint2D& p) {
        return static_cast<int>(std::floor((p.y - grid.origin.y()) / grid.resolution));
    };
    const double steps = std::ceil(10 * core::lengthOf(wall) / grid.resolution);
    int lastX = column(wall.line.point1), lastY = row(wall.line.point1);
    for (double i = 0; i <= steps; ++i) {
        const TPoint2D p = core::placeAt(wall, i / steps);
        const int x = column(p), y = row(p);
        if (x != lastX && y != lastY) grid.cells[grid.index(x, lastY)] = Cell::Occupied;
        grid.cells[grid.index(x, y)] = Cell::Occupied;
        lastX = x;
        lastY = y;
    }
}

float chanceOfBeingFree(Cell cell) {
    return cell == Cell::Free ? 1.0F : cell == Cell::Occupied ? 0.0F : 0.5F;
}

}  // namespace

OccupancyGrid gridOf(std::span<const core::Wall> walls, double resolution) {
    OccupancyGrid grid = emptyGrid(walls, resolution);
    for (const core::Wall& wall : walls) {
        if (isDrawn(wall)) draw(grid, wall);
    }
    return grid;
}

std::string gridMapBytes(const OccupancyGrid& grid) {
    if (grid.origin.phi() != 0) {
        throw std::runtime_error("a .gridmap cannot hold a grid that is turned");
    }
    const auto f = [](double value) { return static_cast<float>(value); };
    const double x = grid.origin.x(), y = grid.origin.y();
    mrpt::maps::COccupancyGridMap2D map(f(x), f(x + grid.width * grid.resolution), f(y),
                                        f(y + grid.height * grid.resolution), f(grid.resolution));
    map.fill(0.5F);
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            map.setCell(column, row, chanceOfBeingFree(grid.at(column, row)));
        }
    }
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << map;
    return {static_cast<const char*>(stream.getRawBufferData()),
            static_cast<size_t>(stream.getTotalBytesCount())};
}

}  // namespace offmap::maps
