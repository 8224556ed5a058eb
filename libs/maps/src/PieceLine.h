// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "GridFaces.h"

#include <mrpt/math/TPoint2D.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace offmap::maps {

/// A straight line without ends: what a piece of a chain follows. In cells.
struct PieceLine {
    mrpt::math::TPoint2D centre, direction;  ///< unit vector, the way the chain goes

    mrpt::math::TPoint2D normal() const { return {-direction.y, direction.x}; }
    double offset(const mrpt::math::TPoint2D& place) const;    ///< [cells] to the left
    double position(const mrpt::math::TPoint2D& place) const;  ///< [cells] along, from the centre
    mrpt::math::TPoint2D foot(const mrpt::math::TPoint2D& place) const;
};

/// First and second moments of places. Those of a chain are whole numbers (twice the middle of a
/// face is one), so that differences of sums are exact: up to 1e5 cells a side and 1e8 faces.
template <class Number>
struct Moments {
    Number n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    void add(Number px, Number py) {
        n += 1;
        x += px;
        y += py;
        xx += px * px;
        xy += px * py;
        yy += py * py;
    }
};

struct Scatter {
    mrpt::math::TPoint2D centre;
    double n = 0, xx = 0, xy = 0, yy = 0;  ///< of the squares about the centre

    /// [cells^2] The sum of the squared distances to the best line.
    double squaredDistances() const {
        return std::max(0.0, 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy));
    }
    /// Of the best line, to either end.
    mrpt::math::TPoint2D direction() const {
        const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
        return {std::cos(angle), std::sin(angle)};
    }
    bool hasDirection() const { return std::hypot(0.5 * (xx - yy), xy) > 1e-9; }
};

/// \param origin of the moments
Scatter scatterOf(const Moments<double>& m, const mrpt::math::TPoint2D& origin);

/// The best line. \param along tells its direction if the scatter does not, and which way it goes
PieceLine lineOf(const Scatter& scatter, const mrpt::math::TPoint2D& along);

/// The line of least squares through places. \pre there is one
PieceLine fitLine(std::span<const mrpt::math::TPoint2D> places, const mrpt::math::TPoint2D& along);

/// [cells] The middle of a face.
mrpt::math::TPoint2D middleOf(const Face& face);

/// The middle of the narrowest strip that holds the middles of all faces. One of its borders runs
/// along an edge of their convex hull.
PieceLine midlineOf(std::span<const Face> faces, const mrpt::math::TPoint2D& along);

}  // namespace offmap::maps
