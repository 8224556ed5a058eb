// SPDX-License-Identifier: BSD-3-Clause
#include "AzimuthArcs.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cstddef>

namespace offmap::rawlog {

namespace {

using mrpt::math::TPoint3Df;

/// [rad] To either side of an arc's first point. Less than between the columns of any scanner, more
/// than what float coordinates leave uncertain.
constexpr double halfLength = mrpt::DEG2RAD(0.02);
/// Fewer on average are no columns.
constexpr size_t pointsPerArc = 4;

/// The arc of a point that has an azimuth and of those behind it, up to the first one that looks
/// another way.
AzimuthArc arcFrom(std::span<const TPoint3Df> points, size_t first) {
    const double x0 = points[first].x, y0 = points[first].y;
    double least = 0, greatest = 0, sum = 0;  // [rad] from the first point
    AzimuthArc arc;
    arc.first = first;
    arc.points = 1;
    for (arc.end = first + 1; arc.end < points.size(); ++arc.end) {
        const TPoint3Df& point = points[arc.end];
        if (!hasAzimuth(point)) continue;
        const double x = point.x, y = point.y;
        const double along = x0 * x + y0 * y, across = x0 * y - y0 * x;
        if (std::abs(across) > halfLength * along) break;
        const double angle = across / along;  // its tangent: 1.4e-11 rad more at most
        least = std::min(least, angle);
        greatest = std::max(greatest, angle);
        sum += angle;
        ++arc.points;
    }
    arc.begin = mrpt::math::wrapToPi(std::atan2(y0, x0) + least);
    arc.length = greatest - least;
    arc.sum = sum - least * static_cast<double>(arc.points);
    return arc;
}

bool beginsBefore(const AzimuthArc& a, const AzimuthArc& b) { return a.begin < b.begin; }

}  // namespace

std::vector<AzimuthArc> arcsInOrder(std::span<const TPoint3Df> points) {
    std::vector<AzimuthArc> arcs;
    const size_t most = points.size() / pointsPerArc;
    auto next = std::ranges::find_if(points, hasAzimuth);
    while (next != points.end()) {
        if (arcs.size() == most) return {};
        arcs.push_back(arcFrom(points, static_cast<size_t>(next - points.begin())));
        next = points.begin() + static_cast<std::ptrdiff_t>(arcs.back().end);
    }
    if (!arcs.empty()) arcs.front().first = 0;
    if (!std::is_sorted(arcs.begin(), arcs.end(), beginsBefore)) {
        std::sort(arcs.begin(), arcs.end(), beginsBefore);
    }
    return arcs;
}

std::vector<AzimuthArc> arcsOfPoints(std::span<const TPoint3Df> points) {
    std::vector<double> azimuths;
    azimuths.reserve(points.size());
    for (const TPoint3Df& p : points) {
        if (hasAzimuth(p)) azimuths.push_back(azimuthOf(p));
    }
    std::sort(azimuths.begin(), azimuths.end());
    std::vector<AzimuthArc> arcs(azimuths.size());
    for (size_t i = 0; i < arcs.size(); ++i) {
        arcs[i].begin = azimuths[i];
        arcs[i].points = 1;
    }
    return arcs;
}

}  // namespace offmap::rawlog
