// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <cstddef>
#include <vector>

namespace offmap::maps {

/// What is left of the lines of a drawing.
struct CleanedWalls {
    std::vector<core::Wall>
        walls;            ///< in the order in which they stood, or the first of those merged
    size_t merged = 0;    ///< walls that others hold or continue
    size_t tooShort = 0;  ///< that joined nothing of minLength
};

/// Lines of one layer, each wall once. Straight walls of equal sigma and height become one where
/// they overlap or touch and lie on one line within a tenth of sigma (0.1 mm ... 5 mm); arcs where
/// they are the same. Gaps stay, since they may be doors, and so do both faces of a wall. Walls
/// shorter than minLength are dropped, unless together with those that join their ends, end to end,
/// they reach further. Cleaning again changes nothing, and the order of the walls does not matter.
/// \param minLength [m]
CleanedWalls cleaned(const std::vector<core::Wall>& walls, double minLength);

/// [m] How far lines may stand apart to be one.
double mergeTolerance(double sigma);

}  // namespace offmap::maps
