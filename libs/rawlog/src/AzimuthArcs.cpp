// SPDX-License-Identifier: BSD-3-Clause
#include "AzimuthArcs.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <optional>

namespace offmap::rawlog {

namespace {

using mrpt::math::TPoint3Df;

/// [rad] To either side of an arc's first point. Less than between the columns of any scanner, more
/// than what float coordinates leave uncertain.
constexpr double halfLength = mrpt::DEG2RAD(0.02);
/// Fewer on average are no columns.
constexpr size_t pointsPerArc = 4;

/// An arc that grows, seen from its first point.
class GrowingArc {
 public:
    GrowingArc(const TPoint3Df& point, size_t place) : x_(point.x), y_(point.y) {
        arc_.first = place;
        arc_.points = 1;
    }

    /// False if the point looks another way.
    bool take(const TPoint3Df& point) {
        const double x = point.x, y = point.y;
        const double along = x_ * x + y_ * y, across = x_ * y - y_ * x;
        if (std::abs(across) > halfLength * along) return false;
        const double angle = across / along;  // its tangent: 1.4e-11 rad more at most
        least_ = std::min(least_, angle);
        greatest_ = std::max(greatest_, angle);
        arc_.sum += angle;
        ++arc_.points;
        return true;
    }

    AzimuthArc endedAt(size_t place) const {
        AzimuthArc arc = arc_;
        arc.begin = mrpt::math::wrapToPi(std::atan2(y_, x_) + least_);
        arc.length = greatest_ - least_;
        arc.sum -= least_ * static_cast<double>(arc.points);
        arc.end = place;
        return arc;
    }

 private:
    double x_, y_;                     ///< [m] its first point
    double least_ = 0, greatest_ = 0;  ///< [rad] from there
    AzimuthArc arc_;                   ///< its sum from there, too
};

bool beginsBefore(const AzimuthArc& a, const AzimuthArc& b) { return a.begin < b.begin; }

}  // namespace

std::vector<AzimuthArc> arcsInOrder(std::span<const TPoint3Df> points) {
    std::vector<AzimuthArc> arcs;
    const size_t most = points.size() / pointsPerArc;
    std::optional<GrowingArc> growing;
    for (size_t i = 0; i < points.size(); ++i) {
        if (!hasAzimuth(points[i]) || (growing && growing->take(points[i]))) continue;
        if (arcs.size() == most) return {};
        if (growing) arcs.push_back(growing->endedAt(i));
        growing.emplace(points[i], arcs.empty() ? 0 : i);
    }
    if (growing) arcs.push_back(growing->endedAt(points.size()));
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
