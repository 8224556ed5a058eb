// SPDX-License-Identifier: BSD-3-Clause
#include "LineArcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace offmap::maps {

namespace {

using mrpt::math::TPoint2D;
using Places = std::span<const TPoint2D>;

constexpr double samePlace = 1e-6;  // [m]
constexpr double offset = 0.001;    // [m] of a corner of the line from the arc
constexpr double bulge = 0.002;     // [m] of the arc from a piece of the line
constexpr double flat = 0.0001;     // [m] an arc that stands off its chord by less is straight
constexpr size_t fewestPieces = 4;  // fewer are drawn on purpose
constexpr double mostTurn = 20 * std::numbers::pi / 180;         // [rad] from piece to piece; ditto
constexpr double mostSweep = std::numbers::pi / 2 * (1 + 1e-9);  // [rad] of a wall

double cross(const TPoint2D& a, const TPoint2D& b) { return a.x * b.y - a.y * b.x; }

/// [rad] positive to the left
double turnAt(const TPoint2D& before, const TPoint2D& corner, const TPoint2D& behind) {
    const TPoint2D in = corner - before, out = behind - corner;
    return std::atan2(cross(in, out), in.x * out.x + in.y * out.y);
}

struct Circle {
    TPoint2D centre;  ///< [m]
    double radius;    ///< [m]
};

/// Through three places; none if they are in line.
std::optional<Circle> circleThrough(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c) {
    const TPoint2D u = b - a, v = c - a;
    const double area = 2 * cross(u, v), u2 = u.sqrNorm(), v2 = v.sqrNorm();
    if (area == 0) return std::nullopt;
    const TPoint2D centre{(v.y * u2 - u.y * v2) / area, (u.x * v2 - v.x * u2) / area};
    return Circle{a + centre, centre.norm()};
}

/// How many of the places, from the first on, turn one way by little.
size_t smoothRun(Places places) {
    if (places.size() < 3) return places.size();
    const bool left = turnAt(places[0], places[1], places[2]) > 0;
    size_t end = 2;
    for (; end < places.size(); ++end) {
        const double turn = turnAt(places[end - 2], places[end - 1], places[end]);
        if (turn == 0 || (turn > 0) != left || std::abs(turn) > mostTurn) break;
    }
    return end;
}

/// The arc from the first place to the last, if all lie along it.
std::optional<core::Wall> arcAlong(Places places, const core::Wall& like) {
    const TPoint2D &first = places.front(), &last = places.back();
    const auto circle = circleThrough(first, places[places.size() / 2], last);
    if (!circle) return std::nullopt;
    const double r = circle->radius, chord = (last - first).norm();
    const double sweep = 2 * std::asin(std::min(1.0, chord / (2 * r)));
    // the half that does not hold the middle place is not meant
    const double side = cross(last - first, places[places.size() / 2] - first) / chord;
    if (!(sweep <= mostSweep) || std::abs(side) > r) return std::nullopt;
    for (size_t i = 1; i < places.size(); ++i) {
        const double piece = (places[i] - places[i - 1]).norm();
        const bool follows = std::abs((places[i] - circle->centre).norm() - r) <= offset &&
                             piece * piece <= 8 * r * bulge;
        if (!follows) return std::nullopt;
    }
    core::Wall wall = like;
    wall.line = {first, last};
    // with its middle on the right it bends to the left
    if (std::abs(side) >= flat) wall.curvature = (side < 0 ? 1 : -1) / r;
    return wall;
}

/// The longest of the runs from the first place that an arc follows, and its number of places.
std::pair<std::optional<core::Wall>, size_t> longestArc(Places run, const core::Wall& like) {
    size_t most = 0, tooMany = run.size() + 1;
    std::optional<core::Wall> arc;
    for (size_t count = fewestPieces + 1; count <= run.size() && count < tooMany;) {
        if (auto found = arcAlong(run.first(count), like)) {
            arc = found;
            most = count;
            count = tooMany > run.size() ? std::min(run.size(), 2 * count) : (most + tooMany) / 2;
        } else {
            tooMany = count;
            count = (most + tooMany) / 2;
        }
        if (most == 0 || count <= most) break;
    }
    return {arc, most};
}

std::vector<TPoint2D> distinct(Places places) {
    std::vector<TPoint2D> all;
    for (const TPoint2D& place : places) {
        if (all.empty() || (place - all.back()).norm() > samePlace) all.push_back(place);
    }
    return all;
}

}  // namespace

std::vector<core::Wall> wallsThrough(Places places, const core::Wall& like) {
    const std::vector<TPoint2D> line = distinct(places);
    std::vector<core::Wall> walls;
    size_t runEnd = 0;  // of the smooth run that was seen last
    for (size_t i = 0; i + 1 < line.size();) {
        if (runEnd < i + 3) runEnd = i + smoothRun(Places(line).subspan(i));
        const auto [arc, count] = longestArc(Places(line).subspan(i, runEnd - i), like);
        walls.push_back(arc.value_or(like));
        if (!arc) walls.back().line = {line[i], line[i + 1]};
        i += arc ? count - 1 : 1;
    }
    return walls;
}

}  // namespace offmap::maps
