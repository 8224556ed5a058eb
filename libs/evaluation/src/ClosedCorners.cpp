// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/WallTracer.h>

#include <cmath>
#include <optional>

namespace offmap::evaluation {

using mrpt::math::TPoint2D;
using mrpt::math::TSegment2D;

namespace {

double cross(const TPoint2D& a, const TPoint2D& b) { return a.x * b.y - a.y * b.x; }

/// Where the lines of two walls cross, if not at less than 30 degrees.
std::optional<TPoint2D> crossing(const TSegment2D& a, const TSegment2D& b) {
    constexpr double leastSine = 0.5;
    const TPoint2D alongA = a.point2 - a.point1, alongB = b.point2 - b.point1;
    const double sine = cross(alongA, alongB);  // times both lengths
    if (!(std::abs(sine) >= leastSine * alongA.norm() * alongB.norm())) return std::nullopt;
    return a.point1 + alongA * (cross(b.point1 - a.point1, alongB) / sine);
}

/// The nearest place within maxGap of a wall's end at which its line meets another wall.
std::optional<TPoint2D> cornerAt(const TPoint2D& end, size_t own,
                                 const std::vector<core::Wall>& walls, double maxGap) {
    std::optional<TPoint2D> corner;
    double least = maxGap;
    for (size_t other = 0; other < walls.size(); ++other) {
        if (other == own) continue;
        const auto place = crossing(walls[own].line, walls[other].line);
        if (!place || walls[other].line.distance(*place) > maxGap) continue;
        const double gap = (*place - end).norm();
        if (gap > least) continue;
        least = gap;
        corner = place;
    }
    return corner;
}

}  // namespace

void closeCorners(std::vector<core::Wall>& walls, double maxGap) {
    const std::vector<core::Wall> open = walls;
    for (size_t i = 0; i < walls.size(); ++i) {
        if (open[i].line.length() <= 2 * maxGap) continue;  // might turn round
        TSegment2D& line = walls[i].line;
        if (const auto corner = cornerAt(line.point1, i, open, maxGap)) line.point1 = *corner;
        if (const auto corner = cornerAt(line.point2, i, open, maxGap)) line.point2 = *corner;
    }
}

}  // namespace offmap::evaluation
