// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <mrpt/math/TPoint2D.h>

namespace offmap::core {

/// The circle of a bent wall in axes of its own: u along the chord, v to the left of it, the origin
/// in the chord's middle. With the curvature k, half the chord h and c = sqrt(1 - (k h)^2), the
/// cosine of half the arc's angle, the circle is
///     k (u^2 + v^2 - h^2) - 2 c v = 0
/// and nothing below divides by k where the wall is all but straight.
class BentWall {
 public:
    /// \pre wall.curvature is not 0 and at most 2 / wall.line.length()
    explicit BentWall(const Wall& wall);

    double length() const;  ///< [m]

    /// [m] From the circle, to the left of the wall's way.
    double leftOf(const mrpt::math::TPoint2D& place) const;
    /// Unit normal of the circle nearest to the place, to the left.
    mrpt::math::TPoint2D leftNormal(const mrpt::math::TPoint2D& place) const;
    /// Whether the place on the circle nearest to this one belongs to the arc.
    bool facesArc(const mrpt::math::TPoint2D& place) const;

    /// [-] of the way: 0 and 1 are the ends.
    double share(const mrpt::math::TPoint2D& place) const;
    mrpt::math::TPoint2D placeAt(double share) const;

    /// [m] How far the arc reaches along a unit vector. \param ofEnds how far its ends do
    double reach(const mrpt::math::TPoint2D& direction, double ofEnds) const;

    /// Where a line crosses the circle.
    struct Crossings {
        double toLeft, toRight;  ///< [m] range; who walks the wall's way gets to that side of it
        bool any;                ///< else the line passes by, and the ranges are nearest to it
    };
    Crossings cross(const mrpt::math::TPoint2D& origin,
                    const mrpt::math::TPoint2D& direction) const;
    /// Whether an arc with both ends on one side of a line can reach to the other side between
    /// them. \param onRight whether the ends are on its right
    bool dips(const mrpt::math::TPoint2D& direction, bool onRight) const;

 private:
    /// Components along the chord and to the left of it.
    mrpt::math::TPoint2D turned(const mrpt::math::TPoint2D& inMap) const;
    mrpt::math::TPoint2D toLocal(const mrpt::math::TPoint2D& place) const;
    mrpt::math::TPoint2D turnedBack(const mrpt::math::TPoint2D& local) const;

    mrpt::math::TPoint2D middle_;  // [m] of the chord
    mrpt::math::TPoint2D along_;   // unit vector
    double half_;                  // [m] h
    double curvature_;             // [1/m] k
    double sine_, cosine_;         // of half the arc's angle: k h, with its sign, and c
};

}  // namespace offmap::core
