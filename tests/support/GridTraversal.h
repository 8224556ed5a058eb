// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/OccupancyGrid.h>

#include <mrpt/math/TPoint2D.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace offmap::test {

/// [m] Where a ray enters the first occupied cell: exact traversal, cell by cell, after Amanatides
/// and Woo. None if it leaves the grid before. \pre the grid's origin has no yaw, and the ray
/// begins inside of it \param direction unit vector
inline std::optional<double> traversedRange(const maps::OccupancyGrid& grid,
                                            const mrpt::math::TPoint2D& origin,
                                            const mrpt::math::TPoint2D& direction) {
    struct Axis {
        int cell, step;
        double next, between;  ///< [m] of range to the next border, and from border to border
    };
    const auto axis = [&](double place, double along) -> Axis {
        const double cells = place / grid.resolution;
        const int cell = static_cast<int>(std::floor(cells));
        constexpr double never = std::numeric_limits<double>::infinity();
        if (along == 0) return {cell, 0, never, never};
        const double border = along > 0 ? cell + 1 - cells : cells - cell;
        const double metres = grid.resolution / std::abs(along);
        return {cell, along > 0 ? 1 : -1, border * metres, metres};
    };
    Axis x = axis(origin.x - grid.origin.x(), direction.x);
    Axis y = axis(origin.y - grid.origin.y(), direction.y);
    double range = 0;
    while (x.cell >= 0 && y.cell >= 0 && x.cell < grid.width && y.cell < grid.height) {
        if (grid.at(x.cell, y.cell) == maps::Cell::Occupied) return range;
        Axis& nearer = x.next < y.next ? x : y;
        range = nearer.next;
        nearer.next += nearer.between;
        nearer.cell += nearer.step;
    }
    return std::nullopt;
}

/// A grid as it is drawn, the highest row first: # occupied, . free, anything else unknown. Cells
/// of 1 m from the origin.
inline maps::OccupancyGrid gridFromText(const std::vector<std::string>& rows) {
    auto grid = maps::makeGrid(rows.front().size(), rows.size(), 1, maps::Cell::Unknown, "drawn");
    for (size_t row = 0; row < rows.size(); ++row) {
        for (size_t x = 0; x < rows[row].size(); ++x) {
            const char c = rows[row][x];
            grid.cells[grid.index(static_cast<int>(x), static_cast<int>(rows.size() - 1 - row))] =
                c == '#'   ? maps::Cell::Occupied
                : c == '.' ? maps::Cell::Free
                           : maps::Cell::Unknown;
        }
    }
    return grid;
}

/// A square grid about the origin whose cells are occupied where their middle is inside.
inline maps::OccupancyGrid gridOfShape(
    double halfSide, double resolution,
    const std::function<bool(const mrpt::math::TPoint2D&)>& isInside) {
    const auto side = static_cast<uint64_t>(std::lround(2 * halfSide / resolution));
    auto grid = maps::makeGrid(side, side, resolution, maps::Cell::Free, "shape");
    grid.origin = {-halfSide, -halfSide, 0};
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const mrpt::math::TPoint2D middle{(x + 0.5) * resolution - halfSide,
                                              (y + 0.5) * resolution - halfSide};
            if (isInside(middle)) grid.cells[grid.index(x, y)] = maps::Cell::Occupied;
        }
    }
    return grid;
}

}  // namespace offmap::test
