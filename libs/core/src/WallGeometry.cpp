// SPDX-License-Identifier: BSD-3-Clause
#include "BentWall.h"
#include "RootOfSquares.h"

#include <offmap/core/WallGeometry.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

double dot(const TPoint2D& a, const TPoint2D& b) { return a.x * b.x + a.y * b.y; }

bool isStraight(const Wall& wall) { return wall.curvature == 0; }

/// How the ends of a wall lie to a ray.
struct EndsByRay {
    EndsByRay(const Wall& wall, const TPoint2D& origin, const TPoint2D& direction) {
        const TPoint2D a = wall.line.point1 - origin, b = wall.line.point2 - origin;
        leftA = direction.x * a.y - direction.y * a.x;
        leftB = direction.x * b.y - direction.y * b.x;
        alongA = direction.x * a.x + direction.y * a.y;
        alongB = direction.x * b.x + direction.y * b.y;
    }
    double leftA, leftB, alongA, alongB;  // [m]
};

std::optional<double> rangeToStraight(const EndsByRay& ends) {
    const auto& [leftA, leftB, alongA, alongB] = ends;
    if ((leftA > 0 && leftB > 0) || (leftA < 0 && leftB < 0)) return std::nullopt;
    if (leftA == leftB) {  // both 0: the wall lies along the ray
        if (alongA < 0 && alongB < 0) return std::nullopt;
        return std::max(std::min(alongA, alongB), 0.0);
    }
    const double range = alongA + leftA / (leftA - leftB) * (alongB - alongA);
    if (range < 0) return std::nullopt;
    return range;
}

/// A line crosses an arc between ends on either side of it once, going the way these stand; between
/// ends on one side, twice or not at all.
std::optional<double> rangeToBent(const BentWall& bent, const EndsByRay& ends,
                                  const TPoint2D& origin, const TPoint2D& direction) {
    const auto crossings = bent.cross(origin, direction);
    std::optional<double> nearest;
    const auto consider = [&nearest](double range) {
        if (range >= 0 && (!nearest || range < *nearest)) nearest = range;
    };
    const bool rightA = ends.leftA < 0, rightB = ends.leftB < 0;
    const bool both = rightA == rightB && bent.dips(direction, rightA) && crossings.any;
    if (both || (rightA && !rightB)) consider(crossings.toLeft);
    if (both || (!rightA && rightB)) consider(crossings.toRight);
    if (ends.leftA == 0) consider(ends.alongA);
    if (ends.leftB == 0) consider(ends.alongB);
    return nearest;
}

}  // namespace

double lengthOf(const Wall& wall) {
    return isStraight(wall) ? wall.line.length() : BentWall(wall).length();
}

double distanceTo(const Wall& wall, const TPoint2D& place) {
    if (isStraight(wall)) {
        const TPoint2D along = wall.line.point2 - wall.line.point1;
        const TPoint2D from = place - wall.line.point1;
        const double share = std::clamp(dot(from, along) / along.sqrNorm(), 0.0, 1.0);
        return std::sqrt((from - along * share).sqrNorm());
    }
    const BentWall bent(wall);
    if (bent.facesArc(place)) return std::abs(bent.leftOf(place));
    return std::min((place - wall.line.point1).norm(), (place - wall.line.point2).norm());
}

double shareAlong(const Wall& wall, const TPoint2D& place) {
    if (!isStraight(wall)) return std::clamp(BentWall(wall).share(place), 0.0, 1.0);
    const TPoint2D along = wall.line.point2 - wall.line.point1;
    const TPoint2D from = place - wall.line.point1;
    return std::clamp((from.x * along.x + from.y * along.y) / along.sqrNorm(), 0.0, 1.0);
}

TPoint2D placeAt(const Wall& wall, double share) {
    if (!isStraight(wall)) return BentWall(wall).placeAt(share);
    return wall.line.point1 + (wall.line.point2 - wall.line.point1) * share;
}

TPoint2D normalAwayFrom(const TPoint2D& beam, const Wall& wall, const TPoint2D& place) {
    const TPoint2D along = wall.line.point2 - wall.line.point1;
    const TPoint2D normal = isStraight(wall) ? TPoint2D(-along.y, along.x) * (1 / along.norm())
                                             : BentWall(wall).leftNormal(place);
    return turnedAlong(beam, normal);
}

double distanceBehind(const TPoint2D& place, const Wall& wall, const TPoint2D& normal) {
    if (isStraight(wall)) return dot(normal, place - wall.line.point1);
    const BentWall bent(wall);
    const double left = bent.leftOf(place);
    return dot(normal, bent.leftNormal(place)) < 0 ? -left : left;
}

std::optional<double> rangeTo(const Wall& wall, const TPoint2D& origin, const TPoint2D& direction) {
    const EndsByRay ends(wall, origin, direction);
    if (isStraight(wall)) return rangeToStraight(ends);
    return rangeToBent(BentWall(wall), ends, origin, direction);
}

Incidence incidenceOn(const Wall& wall, const TPoint2D& direction, const TPoint2D& place) {
    TPoint2D along = wall.line.point2 - wall.line.point1;
    if (!isStraight(wall)) {
        const TPoint2D normal = BentWall(wall).leftNormal(place);
        along = {normal.y, -normal.x};
    }
    return {std::abs(direction.x * along.y - direction.y * along.x),
            std::abs(direction.x * along.x + direction.y * along.y)};
}

double Incidence::sine() const { return across / rootOfSquares(across, along); }

double Incidence::angle() const {
    return std::max(std::atan2(across, along), std::numeric_limits<double>::min());
}

WallBounds boundsOf(const Wall& wall) {
    const auto& [a, b] = wall.line;
    WallBounds bounds{{std::min(a.x, b.x), std::min(a.y, b.y)},
                      {std::max(a.x, b.x), std::max(a.y, b.y)}};
    if (isStraight(wall)) return bounds;
    const BentWall bent(wall);
    bounds.low.x = std::min(bounds.low.x, -bent.reach({-1, 0}, -bounds.low.x));
    bounds.low.y = std::min(bounds.low.y, -bent.reach({0, -1}, -bounds.low.y));
    bounds.high.x = bent.reach({1, 0}, bounds.high.x);
    bounds.high.y = bent.reach({0, 1}, bounds.high.y);
    return bounds;
}

}  // namespace offmap::core
