// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <ogr_spatialref.h>
#include <span>

namespace offmap::maps {

/// Those that cannot be converted become infinite.
void convert(OGRCoordinateTransformation& conversion, std::span<mrpt::math::TPoint2D> points);

/// The corners of the smallest rectangle along the axes that holds all finite points.
struct Extent {
    mrpt::math::TPoint2D low, high;

    double width() const { return high.x - low.x; }
    double depth() const { return high.y - low.y; }
    bool isEmpty() const { return !(low.x <= high.x && low.y <= high.y); }
};
Extent extentOf(std::span<const mrpt::math::TPoint2D> points);

}  // namespace offmap::maps
