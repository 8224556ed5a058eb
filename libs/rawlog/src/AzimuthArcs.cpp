// SPDX-License-Identifier: BSD-3-Clause
#include "AzimuthArcs.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/core/Lanes.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace offmap::rawlog {

namespace {

/// [rad] To either side of an arc's first point. Less than between the columns of any scanner, more
/// than what float coordinates leave uncertain.
constexpr float halfLength = mrpt::DEG2RAD(0.02F);
/// So many tell whether points stand in columns.
constexpr size_t someArcs = 64;

/// Angles [rad] from an arc's first point to others, of one at a time or of as many as there are
/// lanes. Their tangents stand for them: 1.4e-11 rad more at most. In floats, which leave them as
/// uncertain as the coordinates do that they are of: by 1e-7 rad.
template <class Numbers>
class ArcAngles {
 public:
    ArcAngles(float x0, float y0) : x0_(x0), y0_(y0) {}

    /// Adds all or none. \return false if a point looks another way
    [[gnu::always_inline]] bool add(const float* xs, const float* ys) {
        Numbers x, y;
        core::load(xs, x);
        core::load(ys, y);
        const Numbers along = x0_ * x + y0_ * y, across = x0_ * y - y0_ * x;
        const Numbers widest = halfLength * along;
        const Numbers squared = x * x + y * y;
        const auto seen = squared >= minSquaredGroundRange;
        if (core::any(seen & ((across > widest) | (-across > widest)))) return false;
        const Numbers none{}, angles = seen ? across / along : none;
        least_ = angles < least_ ? angles : least_;
        greatest_ = angles > greatest_ ? angles : greatest_;
        sum_ += angles;
        points_ += seen ? none + 1 : none;
        furthest_ = squared > furthest_ ? squared : furthest_;
        return true;
    }

    const Numbers& least() const { return least_; }
    const Numbers& greatest() const { return greatest_; }
    const Numbers& sum() const { return sum_; }
    const Numbers& points() const { return points_; }
    const Numbers& furthest() const { return furthest_; }  ///< [m^2] from the axis

 private:
    float x0_, y0_;
    Numbers least_{}, greatest_{}, sum_{}, points_{}, furthest_{};
};

/// The arc of a point that has an azimuth and of those behind it, up to the first one that looks
/// another way.
OFFMAP_BY_PROCESSOR AzimuthArc arcFrom(const CloudPoints& points, uint32_t first) {
    const float *x = points.x.data(), *y = points.y.data();
    const auto count = static_cast<uint32_t>(points.size());
    ArcAngles<core::Lanes> many(x[first], y[first]);
    ArcAngles<float> rest(x[first], y[first]);
    uint32_t end = first;
    while (end + core::laneCount <= count && many.add(x + end, y + end)) end += core::laneCount;
    while (end < count && rest.add(x + end, y + end)) ++end;

    float least = rest.least(), greatest = rest.greatest(), furthest = rest.furthest();
    double sum = rest.sum(), seen = rest.points();
    for (uint32_t lane = 0; lane < core::laneCount; ++lane) {
        least = std::min(least, many.least()[lane]);
        greatest = std::max(greatest, many.greatest()[lane]);
        furthest = std::max(furthest, many.furthest()[lane]);
        sum += many.sum()[lane];
        seen += many.points()[lane];
    }
    AzimuthArc arc;
    arc.first = first;
    arc.end = end;
    arc.points = static_cast<uint32_t>(seen);
    arc.clear = furthest >= clearSquaredGroundRange;
    arc.begin = wrapped(azimuthOf(x[first], y[first]) + least);
    arc.length = greatest - least;
    arc.sum = sum - least * seen;
    return arc;
}

}  // namespace

std::vector<AzimuthArc> arcsInOrder(const CloudPoints& points) {
    std::vector<AzimuthArc> arcs;
    uint32_t next = 0;
    while (next < points.size() && !hasAzimuth(points.x[next], points.y[next])) ++next;
    while (next < points.size()) {
        if (arcs.size() > someArcs + next / pointsPerArc) return {};
        arcs.push_back(arcFrom(points, next));
        next = arcs.back().end;
    }
    if (!arcs.empty()) arcs.front().first = 0;
    return arcs;
}

BinnedArcs arcsInBins(const CloudPoints& points) {
    constexpr uint32_t bins = 1 << 16;
    constexpr double width = 2 * std::numbers::pi / bins;  // [rad] 0.0055 degrees
    struct Bin {
        double least = 0, greatest = 0, sum = 0;  // [rad] from where it begins
        uint32_t points = 0, arc = 0;
        bool clear = false;
    };
    std::vector<Bin> filled(bins);
    BinnedArcs out{{}, std::vector<uint32_t>(points.size(), BinnedArcs::none)};
    for (uint32_t i = 0; i < points.size(); ++i) {
        if (!hasAzimuth(points.x[i], points.y[i])) continue;
        const double fromStart = azimuthOf(points.x[i], points.y[i]) + std::numbers::pi;
        const uint32_t b = std::min(bins - 1, static_cast<uint32_t>(fromStart / width));
        const double angle = fromStart - b * width;
        Bin& bin = filled[b];
        bin.least = bin.points == 0 ? angle : std::min(bin.least, angle);
        bin.greatest = bin.points == 0 ? angle : std::max(bin.greatest, angle);
        bin.sum += angle;
        ++bin.points;
        bin.clear = bin.clear || isClear(points.x[i], points.y[i]);
        out.arcOf[i] = b;
    }
    for (uint32_t b = 0; b < bins; ++b) {
        Bin& bin = filled[b];
        if (bin.points == 0) continue;
        bin.arc = static_cast<uint32_t>(out.arcs.size());
        AzimuthArc& arc = out.arcs.emplace_back();
        arc.begin = b * width - std::numbers::pi + bin.least;
        arc.length = bin.greatest - bin.least;
        arc.sum = bin.sum - bin.least * bin.points;
        arc.points = bin.points;
        arc.clear = bin.clear;
    }
    for (uint32_t& arc : out.arcOf) {
        if (arc != BinnedArcs::none) arc = filled[arc].arc;
    }
    return out;
}

}  // namespace offmap::rawlog
