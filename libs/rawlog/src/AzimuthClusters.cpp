// SPDX-License-Identifier: BSD-3-Clause
#include "AzimuthClusters.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace offmap::rawlog {

namespace {

constexpr double fullTurn = 2.0 * std::numbers::pi;
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

/// The gap [rad] that, with those larger, takes up so much of the angle; found without sorting.
std::optional<double> gapThatFills(double angle, std::vector<double> gaps) {
    if (gaps.empty() || std::accumulate(gaps.begin(), gaps.end(), 0.0) < angle) return {};
    auto begin = gaps.begin(), end = gaps.end();
    while (end - begin > 1) {
        const auto middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end, std::greater<>());
        const double larger = std::accumulate(begin, middle, 0.0);
        if (larger < angle) {
            angle -= larger;
            begin = middle;
        } else {
            end = middle;
        }
    }
    return *begin;
}

/// The gap [rad] that divides columns, if the azimuths are clustered. Between clear clusters lies
/// nearly all of the angle; the typical such gap is thus the median of the gaps, weighted by their
/// own size. Evenly or randomly spread azimuths fail both conditions. \param gaps 0 within arcs
std::optional<double> dividingGap(std::vector<double> gaps, size_t pointCount) {
    double angle = fullTurn;
    for (const double g : gaps) angle -= g > maxStep ? g : 0;
    std::erase_if(gaps, [](double g) { return g > maxStep; });
    const auto typical = gapThatFills(0.5 * angle, gaps);
    if (!typical) return {};

    const double divide = 0.5 * *typical;
    double larger = 0;
    size_t count = 0;
    for (const double g : gaps) {
        larger += g < divide ? 0 : g;
        count += !(g < divide);
    }
    const bool clear = count < gaps.size() && pointCount >= 4 * count && larger >= 0.8 * angle;
    return clear ? std::optional(divide) : std::nullopt;
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
        const double from = wrapped(arc.begin - arcs[begin % n].begin);
        sum += from * static_cast<double>(arc.points) + arc.sum;
        points += arc.points;
        if (gaps[(k + 1) % n] < divide) continue;
        const double mean = sum / static_cast<double>(points);
        centres.push_back(wrapped(arcs[begin % n].begin + mean));
        begin = k + 1;
        sum = 0;
        points = 0;
    }
    std::sort(centres.begin(), centres.end());
    return centres;
}

}  // namespace

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

}  // namespace offmap::rawlog
