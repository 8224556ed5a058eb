// SPDX-License-Identifier: BSD-3-Clause
#include "PieceLine.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include <limits>

namespace offmap::maps {

using mrpt::math::TPoint2D;

double PieceLine::offset(const TPoint2D& place) const {
    const TPoint2D from = place - centre;
    return direction.x * from.y - direction.y * from.x;
}

double PieceLine::position(const TPoint2D& place) const {
    const TPoint2D from = place - centre;
    return direction.x * from.x + direction.y * from.y;
}

TPoint2D PieceLine::foot(const TPoint2D& place) const { return place - normal() * offset(place); }

TPoint2D middleOf(const Face& face) {
    const Step twice = face.start() + face.end();
    return {0.5 * twice.x, 0.5 * twice.y};
}

PieceLine fitLine(std::span<const TPoint2D> places, const TPoint2D& along) {
    Moments<double> moments;
    for (const TPoint2D& place : places) {
        moments.add(place.x - places.front().x, place.y - places.front().y);
    }
    return lineOf(scatterOf(moments, places.front()), along);
}

Scatter scatterOf(const Moments<double>& m, const TPoint2D& origin) {
    const double x = m.x / m.n, y = m.y / m.n;
    return {origin + TPoint2D{x, y}, m.n, m.xx - x * m.x, m.xy - x * m.y, m.yy - y * m.y};
}

PieceLine lineOf(const Scatter& scatter, const TPoint2D& along) {
    TPoint2D direction = scatter.hasDirection() ? scatter.direction() : along;
    if (direction.x * along.x + direction.y * along.y < 0) direction = direction * -1.0;
    return {scatter.centre, direction * (1 / direction.norm())};
}

PieceLine midlineOf(std::span<const Face> faces, const TPoint2D& along) {
    namespace bg = boost::geometry;
    using Point = bg::model::d2::point_xy<double>;
    bg::model::multi_point<Point> middles;
    for (const Face& face : faces) {
        const TPoint2D middle = middleOf(face);
        middles.emplace_back(middle.x, middle.y);
    }
    bg::model::ring<Point> hull;
    bg::convex_hull(middles, hull);
    PieceLine best{middleOf(faces.front()), along * (1 / along.norm())};
    double narrowest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i + 1 < hull.size(); ++i) {
        const TPoint2D a{hull[i].x(), hull[i].y()}, b{hull[i + 1].x(), hull[i + 1].y()};
        const double length = (b - a).norm();
        if (length == 0) continue;
        const PieceLine edge{a, (b - a) * (1 / length)};
        double furthest = 0;  // all are on one side
        for (const Point& corner : hull) {
            const double offset = edge.offset({corner.x(), corner.y()});
            if (std::abs(offset) > std::abs(furthest)) furthest = offset;
        }
        if (std::abs(furthest) >= narrowest) continue;
        narrowest = std::abs(furthest);
        const bool turned = edge.direction.x * along.x + edge.direction.y * along.y < 0;
        best = {a + edge.normal() * (0.5 * furthest), edge.direction * (turned ? -1.0 : 1.0)};
    }
    return best;
}

}  // namespace offmap::maps
