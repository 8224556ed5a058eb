// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/poses/CPose2D.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace offmap::maps {

/// What is known of a cell.
enum class Cell : uint8_t { Unknown, Free, Occupied };

/// A map of square cells.
struct OccupancyGrid {
    int width = 0, height = 0;    ///< [cells]
    double resolution = 0;        ///< [m] side of a cell
    mrpt::poses::CPose2D origin;  ///< of the grid's lower left corner, in the map frame
    std::vector<Cell> cells;      ///< row by row, the lowest first, each from the left

    /// Cells outside are unknown.
    Cell at(int x, int y) const {
        const bool inside = x >= 0 && y >= 0 && x < width && y < height;
        return inside ? cells[index(x, y)] : Cell::Unknown;
    }
    /// \pre the cell is one of the grid
    size_t index(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
};

/// A grid of equal cells. \param name stands for it in messages
/// \throw std::runtime_error if it has no cell, more than any map needs, or no usable resolution
OccupancyGrid makeGrid(uint64_t width, uint64_t height, double resolution, Cell fill,
                       const std::string& name);

}  // namespace offmap::maps
