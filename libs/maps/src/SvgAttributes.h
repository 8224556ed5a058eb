// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Attributes beyond those of SVG itself.

namespace offmap::maps::svg {

constexpr const char* groupMode = "inkscape:groupmode";
constexpr const char* label = "inkscape:label";

/// [m] of walls, also of all in a group.
constexpr const char *sigma = "data-sigma-m", *zMin = "data-z-min-m", *zMax = "data-z-max-m";

/// [m] "x y" in the map of the lower left corner of the viewBox; without it 0 0.
constexpr const char* lowerLeft = "data-lower-left-m";

}  // namespace offmap::maps::svg
