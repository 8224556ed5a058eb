// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SampleWorlds.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;

constexpr double height = 4;         // [m]
constexpr size_t pieces = 64;        // of the arc, off by 1 mm at most
constexpr double radius = 10;        // [m]
constexpr double halfWidth = 8;      // [m] of the arc's chord, which lies on the x axis
const TPoint2D right(halfWidth, 0);  // where the arc begins
const TPoint2D left(-halfWidth, 0);  // and ends, counter-clockwise
const TPoint2D centre(0, -6);        // sqrt(radius^2 - halfWidth^2) below

/// The ends of the arc's pieces. [m]
std::vector<TPoint2D> pointsOfArc() {
    const double begin = std::atan2(-centre.y, halfWidth);
    const double angle = 2 * std::asin(halfWidth / radius);
    std::vector<TPoint2D> points{right};
    for (size_t i = 1; i < pieces; ++i) {
        const double phi = begin + angle * static_cast<double>(i) / pieces;
        points.push_back(centre + TPoint2D(std::cos(phi), std::sin(phi)) * radius);
    }
    points.push_back(left);
    return points;
}

}  // namespace

World curvedHall(size_t chords) {
    if (chords > 0 && pieces % chords != 0) {
        throw std::invalid_argument("64 pieces of an arc cannot be shared among its chords");
    }
    World world;
    world.addFloor();
    world.addCeiling(height);
    const std::vector<TPoint2D> corners{left, {-halfWidth, -6}, {halfWidth, -6}, right};
    for (size_t i = 0; i + 1 < corners.size(); ++i) {
        world.addMappedPanel({{corners[i], corners[i + 1]}, {0, height}});
    }

    const auto points = pointsOfArc();
    const size_t piecesOfWall = pieces / std::max<size_t>(chords, 1);
    uint32_t wall = 0;
    for (size_t i = 0; i < pieces; ++i) {
        if (i % piecesOfWall == 0) {
            core::Wall shown{.line = {points[i], points[i + piecesOfWall]}};
            if (chords == 0) shown.curvature = 1 / radius;
            wall = world.addToMap(shown);
        }
        world.addPanel({{points[i], points[i + 1]}, {0, height}}, wall);
    }
    world.addObject(personAt({3, -3}));
    world.addObject(Box{{0, 3.5, 0}, 0.8, 0.6, {0, 1.2}});  // crate, 0.2 m before the arc
    return world;
}

}  // namespace offmap::evaluation
