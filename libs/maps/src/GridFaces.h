// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/OccupancyGrid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace offmap::maps {

/// A place or a step among the cells; corners of cells have whole numbers, the cell (x, y) reaches
/// from there to (x + 1, y + 1).
struct Step {
    int x = 0, y = 0;

    friend Step operator+(const Step& a, const Step& b) { return {a.x + b.x, a.y + b.y}; }
    friend Step operator-(const Step& a, const Step& b) { return {a.x - b.x, a.y - b.y}; }
    friend bool operator==(const Step&, const Step&) = default;
};

/// One side of an occupied cell. Who walks along it has the cell at the left.
struct Face {
    Step cell;
    uint8_t side = 0;  ///< 0: right, 1: upper, 2: left, 3: lower

    static constexpr std::array<Step, 4> sides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

    Step outward() const { return sides[side]; }
    Step along() const { return sides[(side + 1) % 4]; }
    Step front() const { return cell + outward(); }
    Step start() const;  ///< a corner of the cell
    Step end() const { return start() + along(); }
    friend bool operator==(const Face&, const Face&) = default;
};

/// Faces of which each begins where the one before ends.
struct FaceChain {
    std::vector<Face> faces;
    bool closed = false;  ///< the first begins where the last ends
};

/// Whether the face can be seen: in front of it is a free cell, with at most two cells between that
/// are unknown, such as a grey rim between black and white.
bool isSeen(const OccupancyGrid& grid, const Face& face);

/// Of the side of the grid's occupied space that can be seen. Cells that touch at a corner belong
/// together.
std::vector<FaceChain> faceChains(const OccupancyGrid& grid);

}  // namespace offmap::maps
