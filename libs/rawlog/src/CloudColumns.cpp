// SPDX-License-Identifier: BSD-3-Clause
#include "AzimuthArcs.h"

#include <offmap/rawlog/CloudColumns.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace offmap::rawlog {

namespace {

using mrpt::math::TPoint3Df;

constexpr double fullTurn = 2.0 * std::numbers::pi;
constexpr double pointsPerColumn = 32;
/// [rad] A larger gap is an edge of the field of view.
constexpr double maxStep = mrpt::DEG2RAD(5.0);

/// Gap [rad] before each of the arcs, around the circle.
std::vector<double> gapsBefore(const std::vector<AzimuthArc>& arcs) {
    double reached = -fullTurn;
    for (const AzimuthArc& arc : arcs) reached = std::max(reached, arc.begin + arc.length);
    reached -= fullTurn;
    std::vector<double> gaps;
    gaps.reserve(arcs.size());
    for (const AzimuthArc& arc : arcs) {
        gaps.push_back(std::max(0.0, arc.begin - reached));
        reached = std::max(reached, arc.begin + arc.length);
    }
    return gaps;
}

/// The gap [rad] that divides columns, if the azimuths are clustered. Between clear clusters lies
/// nearly all of the angle; the typical such gap is thus the median of the gaps, weighted by their
/// own size. Evenly or randomly spread azimuths fail both conditions. \param gaps 0 within arcs
std::optional<double> dividingGap(std::vector<double> gaps, size_t pointCount) {
    double angle = fullTurn;
    for (const double g : gaps) angle -= g > maxStep ? g : 0;
    std::erase_if(gaps, [](double g) { return g > maxStep; });
    std::sort(gaps.begin(), gaps.end(), std::greater<>());

    double larger = 0;
    std::optional<double> divide;
    for (size_t i = 0; i < gaps.size(); ++i) {
        if (divide && gaps[i] < *divide) {
            const bool clear = pointCount >= 4 * i && larger >= 0.8 * angle;
            return clear ? divide : std::nullopt;
        }
        larger += gaps[i];
        if (!divide && larger >= 0.5 * angle) divide = 0.5 * gaps[i];
    }
    return {};
}

/// Mean azimuth [rad] of each run of sorted arcs without a dividing gap, around the circle.
std::vector<double> clusterCentres(const std::vector<AzimuthArc>& arcs,
                                   const std::vector<double>& gaps, double divide) {
    const size_t n = arcs.size();
    const auto firstDivide =
        std::find_if(gaps.begin(), gaps.end(), [&](double g) { return g >= divide; });
    const auto start = static_cast<size_t>(std::distance(gaps.begin(), firstDivide));

    std::vector<double> centres;
    double sum = 0;  // of azimuths, from the cluster's first one
    size_t points = 0;
    size_t begin = start;
    for (size_t k = start; k < start + n; ++k) {
        const AzimuthArc& arc = arcs[k % n];
        const double from = mrpt::math::wrapToPi(arc.begin - arcs[begin % n].begin);
        sum += from * static_cast<double>(arc.points) + arc.sum;
        points += arc.points;
        if (gaps[(k + 1) % n] < divide) continue;
        const double mean = sum / static_cast<double>(points);
        centres.push_back(mrpt::math::wrapToPi(arcs[begin % n].begin + mean));
        begin = k + 1;
        sum = 0;
        points = 0;
    }
    std::sort(centres.begin(), centres.end());
    return centres;
}

/// Centres [rad] of the clusters that the arcs stand in; empty if they do not, or if arcs are so
/// long that there may be gaps in them that divide.
std::vector<double> findClusters(const std::vector<AzimuthArc>& arcs) {
    std::vector<double> gaps = gapsBefore(arcs);
    size_t points = 0;
    double longest = 0;
    for (const AzimuthArc& arc : arcs) {
        points += arc.points;
        longest = std::max(longest, arc.length);
    }
    std::vector<double> all = gaps;
    if (points > arcs.size()) all.push_back(0);
    const auto divide = dividingGap(std::move(all), points);
    if (!divide || longest >= *divide) return {};
    return clusterCentres(arcs, gaps, *divide);
}

/// Index of the azimuth nearest to a, around the circle; `sorted` is not empty.
uint32_t nearestAzimuth(const std::vector<double>& sorted, double a) {
    const auto above = std::lower_bound(sorted.begin(), sorted.end(), a);
    const auto next = above == sorted.end() ? sorted.begin() : above;
    const auto previous = above == sorted.begin() ? std::prev(sorted.end()) : std::prev(above);
    const bool toNext =
        std::abs(mrpt::math::wrapToPi(*next - a)) < std::abs(mrpt::math::wrapToPi(*previous - a));
    return static_cast<uint32_t>(std::distance(sorted.begin(), toNext ? next : previous));
}

double chosenWidth(size_t pointCount) {
    const double even = fullTurn * pointsPerColumn / std::max(1.0, static_cast<double>(pointCount));
    return std::clamp(even, mrpt::DEG2RAD(0.2), mrpt::DEG2RAD(2.0));
}

/// Bins that hold no point are left out.
CloudColumns fixedBins(std::span<const TPoint3Df> points, double width) {
    const auto bins = static_cast<uint32_t>(std::max(1.0, std::round(fullTurn / width)));
    const double exactWidth = fullTurn / bins;
    CloudColumns columns;
    columns.columnOf.reserve(points.size());
    std::vector<uint8_t> used(bins, 0);
    for (const TPoint3Df& p : points) {
        const double fromStart = (azimuthOf(p) + std::numbers::pi) / exactWidth;
        columns.columnOf.push_back(std::min(bins - 1, static_cast<uint32_t>(fromStart)));
        used[columns.columnOf.back()] = 1;
    }
    std::vector<uint32_t> columnOfBin(bins, 0);
    for (uint32_t b = 0; b < bins; ++b) {
        columnOfBin[b] = static_cast<uint32_t>(columns.azimuths.size());
        if (used[b]) columns.azimuths.push_back((b + 0.5) * exactWidth - std::numbers::pi);
    }
    for (uint32_t& c : columns.columnOf) c = columnOfBin[c];
    return columns;
}

/// The column nearest to each point. Where all of an arc has the same, nothing is calculated.
CloudColumns nearestColumns(std::span<const TPoint3Df> points, std::vector<double> azimuths,
                            const std::vector<AzimuthArc>& arcs) {
    CloudColumns columns{std::move(azimuths), std::vector<uint32_t>(points.size())};
    const auto nearest = [&](double azimuth) { return nearestAzimuth(columns.azimuths, azimuth); };
    for (const AzimuthArc& arc : arcs) {
        const uint32_t column = nearest(arc.begin);
        const bool whole = column == nearest(mrpt::math::wrapToPi(arc.begin + arc.length));
        if (whole && arc.points == arc.end - arc.first) {
            std::fill_n(columns.columnOf.begin() + static_cast<std::ptrdiff_t>(arc.first),
                        arc.points, column);
            continue;
        }
        for (size_t i = arc.first; i < arc.end; ++i) {
            const bool known = whole && hasAzimuth(points[i]);
            columns.columnOf[i] = known ? column : nearest(azimuthOf(points[i]));
        }
    }
    return columns;
}

}  // namespace

CloudColumns findCloudColumns(std::span<const TPoint3Df> points, double width) {
    if (width > 0) return fixedBins(points, width);
    const std::vector<AzimuthArc> arcs = arcsInOrder(points);
    std::vector<double> clusters = findClusters(arcs);
    if (!clusters.empty()) return nearestColumns(points, std::move(clusters), arcs);
    clusters = findClusters(arcsOfPoints(points));
    if (clusters.empty()) return fixedBins(points, chosenWidth(points.size()));
    CloudColumns columns{std::move(clusters), {}};
    columns.columnOf.reserve(points.size());
    for (const TPoint3Df& p : points) {
        columns.columnOf.push_back(nearestAzimuth(columns.azimuths, azimuthOf(p)));
    }
    return columns;
}

}  // namespace offmap::rawlog
