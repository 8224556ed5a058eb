// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double fullCircle = 2 * std::numbers::pi;
constexpr double rounding = 1e-9;  // [rad] that sums of angles lose

void requireArc(const CircularArc& arc) {
    if (!(arc.radius > 0)) throw std::invalid_argument("the radius is not above zero");
    for (const double x : {arc.centre.x, arc.centre.y, arc.radius, 1 / arc.radius, arc.start}) {
        if (!std::isfinite(x)) throw std::invalid_argument("an arc of a size that is not finite");
    }
    if (!(arc.sweep > 0)) throw std::invalid_argument("an arc without length");
    if (!(arc.sweep <= fullCircle + rounding)) {
        throw std::invalid_argument("an arc of more than a full circle");
    }
}

TPoint2D placeOn(const CircularArc& arc, double angle) {
    return {arc.centre.x + arc.radius * std::cos(angle),
            arc.centre.y + arc.radius * std::sin(angle)};
}

/// Far from the origin, the ends are rounded to where the chord says another angle.
void requireExact(const Wall& wall, double angle) {
    constexpr double tolerance = 1e-6;  // [-]
    const double half = 0.5 * wall.line.length() * wall.curvature;
    if (std::abs(half - std::sin(angle / 2)) <= tolerance * std::sin(angle / 2)) return;
    throw std::invalid_argument("an arc too small for numbers as large as its centre's");
}

}  // namespace

std::vector<Wall> wallsAlong(const CircularArc& arc, const Wall& like) {
    requireArc(arc);
    const double quarters = std::ceil((arc.sweep - rounding) / (fullCircle / 4));
    const auto count = static_cast<size_t>(std::max(quarters, 1.0));
    const double step = arc.sweep / static_cast<double>(count);
    const bool closed = arc.sweep > fullCircle - rounding;
    std::vector<Wall> walls;
    const TPoint2D first = placeOn(arc, arc.start);
    TPoint2D begin = first;
    for (size_t i = 1; i <= count; ++i) {
        const TPoint2D end =
            closed && i == count ? first : placeOn(arc, arc.start + step * static_cast<double>(i));
        Wall wall = like;
        wall.line = {begin, end};
        wall.curvature = 1 / arc.radius;
        requireExact(wall, step);
        walls.push_back(wall);
        begin = end;
    }
    return walls;
}

}  // namespace offmap::core
