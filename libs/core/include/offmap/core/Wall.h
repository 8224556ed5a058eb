// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Interval.h>

#include <mrpt/math/TSegment2D.h>

namespace offmap::core {

/// A piece of a surface that a range sensor sees, in top view: straight, or an arc of at most half
/// a circle. WallGeometry.h works with both.
struct Wall {
    mrpt::math::TSegment2D line;  ///< [m] map frame; of an arc the chord
    double sigma = 0.03;          ///< [m] standard deviation of its position
    Interval height =
        Interval::everything();  ///< [m] z in the map frame that it reaches from and to
    double curvature = 0;        ///< [1/m] 0: straight; positive: bends to the left on the way from
                                 ///< line.point1 to line.point2, counter-clockwise
};

}  // namespace offmap::core
