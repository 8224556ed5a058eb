// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace offmap::core {

/// Part of a circle, counter-clockwise.
struct CircularArc {
    mrpt::math::TPoint2D centre;  ///< [m] map frame
    double radius;                ///< [m]
    double start;                 ///< [rad] where it begins, CCW from the map's x axis
    double sweep;                 ///< [rad] how far it goes, (0, 2 pi]
};

/// The walls that together are the arc, each of at most a quarter of the circle, in its order; each
/// begins exactly where the one before ends. \param like sigma and height of each
/// \throw std::invalid_argument telling what is wrong if it is no arc that numbers can hold
std::vector<Wall> wallsAlong(const CircularArc& arc, const Wall& like);

}  // namespace offmap::core
