// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <mrpt/math/TPoint2D.h>

#include <optional>

namespace offmap::core {

/// [m] Along the wall.
double lengthOf(const Wall& wall);

/// [m] From a place to the nearest place on the wall, which has ends.
double distanceTo(const Wall& wall, const mrpt::math::TPoint2D& place);

/// [0, 1] of the way from the wall's first end to its second, nearest to a place.
double shareAlong(const Wall& wall, const mrpt::math::TPoint2D& place);

/// The place on the wall at that share of the way.
mrpt::math::TPoint2D placeAt(const Wall& wall, double share);

/// Of the two directions across a wall, the one that goes the beam's way.
inline mrpt::math::TPoint2D turnedAlong(const mrpt::math::TPoint2D& beam,
                                        const mrpt::math::TPoint2D& normal) {
    return normal.x * beam.x + normal.y * beam.y < 0 ? normal * -1.0 : normal;
}

/// Unit normal of the wall where a place is nearest to it, that points the way the beam goes.
/// \param beam map axes
mrpt::math::TPoint2D normalAwayFrom(const mrpt::math::TPoint2D& beam, const Wall& wall,
                                    const mrpt::math::TPoint2D& place);

/// [m] From the wall, as if its line or circle went on past its ends, along that normal: negative
/// in front of it.
double distanceBehind(const mrpt::math::TPoint2D& place, const Wall& wall,
                      const mrpt::math::TPoint2D& normal);

/// [m] Range at which a ray first meets the wall, if it does. A ray along a straight wall meets its
/// nearer end. On which side of the ray an end lies is worked out from that end alone, so that no
/// ray slips through between two walls that share it. \param direction unit vector
std::optional<double> rangeTo(const Wall& wall, const mrpt::math::TPoint2D& origin,
                              const mrpt::math::TPoint2D& direction);

/// The angle between a ray and a wall, kept as a pair until somebody asks for it.
struct Incidence {
    double across, along;  ///< [-] in the ratio of its sine to its cosine, both >= 0

    double angle() const;  ///< [rad] (0, pi/2]
    double sine() const;   ///< [0, 1]
};

/// At the place where a ray and the wall meet.
Incidence incidenceOn(const Wall& wall, const mrpt::math::TPoint2D& direction,
                      const mrpt::math::TPoint2D& place);

/// The smallest rectangle along the axes that holds the wall.
struct WallBounds {
    mrpt::math::TPoint2D low, high;  ///< [m] map frame
};
WallBounds boundsOf(const Wall& wall);

}  // namespace offmap::core
