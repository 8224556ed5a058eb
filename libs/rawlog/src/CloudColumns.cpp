// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudColumns.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>

namespace offmap::rawlog {

namespace {

using mrpt::math::TPoint3Df;

constexpr double fullTurn = 2.0 * std::numbers::pi;
/// [m] Coordinates rounded to 1 mm leave an azimuth uncertain by 0.08 degrees here.
constexpr double minGroundRange = 0.5;
constexpr double pointsPerColumn = 32;
/// [rad] A larger gap is an edge of the field of view.
constexpr double maxStep = mrpt::DEG2RAD(5.0);

double azimuthOf(const TPoint3Df& p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
}

/// Gap [rad] from each of the sorted azimuths to the next, around the circle.
std::vector<double> gapsOf(const std::vector<double>& sorted) {
    std::vector<double> gaps(sorted.size());
    std::adjacent_difference(sorted.begin(), sorted.end(), gaps.begin());
    std::rotate(gaps.begin(), gaps.begin() + 1, gaps.end());
    gaps.back() = sorted.front() + fullTurn - sorted.back();
    return gaps;
}

/// The gap [rad] that divides columns, if the azimuths are clustered. Between clear clusters lies
/// nearly all of the angle; the typical such gap is thus the median of the gaps, weighted by their
/// own size. Evenly or randomly spread azimuths fail both conditions.
std::optional<double> dividingGap(std::vector<double> gaps) {
    const auto pointCount = static_cast<double>(gaps.size());
    std::erase_if(gaps, [](double g) { return g > maxStep; });
    std::sort(gaps.begin(), gaps.end(), std::greater<>());
    double angle = 0;
    for (const double g : gaps) angle += g;

    double larger = 0;
    std::optional<double> divide;
    for (size_t i = 0; i < gaps.size(); ++i) {
        if (divide && gaps[i] < *divide) {
            const bool manyPoints = pointCount >= 4.0 * static_cast<double>(i);
            return manyPoints && larger >= 0.8 * angle ? divide : std::nullopt;
        }
        larger += gaps[i];
        if (!divide && larger >= 0.5 * angle) divide = 0.5 * gaps[i];
    }
    return {};
}

/// Mean azimuth [rad] of each run of sorted azimuths without a dividing gap, around the circle.
std::vector<double> clusterCentres(const std::vector<double>& sorted,
                                   const std::vector<double>& gaps, double divide) {
    const size_t n = sorted.size();
    const auto firstDivide =
        std::find_if(gaps.begin(), gaps.end(), [&](double g) { return g >= divide; });
    const auto start = static_cast<size_t>(std::distance(gaps.begin(), firstDivide)) + 1;

    std::vector<double> centres;
    double sum = 0;  // of azimuths, from the cluster's first one
    size_t begin = start;
    for (size_t k = start; k < start + n; ++k) {
        sum += mrpt::math::wrapToPi(sorted[k % n] - sorted[begin % n]);
        if (gaps[k % n] < divide) continue;
        const double mean = sum / static_cast<double>(k + 1 - begin);
        centres.push_back(mrpt::math::wrapToPi(sorted[begin % n] + mean));
        begin = k + 1;
        sum = 0;
    }
    std::sort(centres.begin(), centres.end());
    return centres;
}

std::optional<std::vector<double>> findClusters(std::span<const TPoint3Df> points) {
    std::vector<double> azimuths;
    azimuths.reserve(points.size());
    for (const TPoint3Df& p : points) {
        if (std::hypot(p.x, p.y) >= minGroundRange) azimuths.push_back(azimuthOf(p));
    }
    if (azimuths.empty()) return {};
    std::sort(azimuths.begin(), azimuths.end());
    const auto gaps = gapsOf(azimuths);
    const auto divide = dividingGap(gaps);
    if (!divide) return {};
    return clusterCentres(azimuths, gaps, *divide);
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

}  // namespace

CloudColumns findCloudColumns(std::span<const TPoint3Df> points, double width) {
    if (width > 0) return fixedBins(points, width);
    const auto clusters = findClusters(points);
    if (!clusters) return fixedBins(points, chosenWidth(points.size()));
    CloudColumns columns{*clusters, {}};
    columns.columnOf.reserve(points.size());
    for (const TPoint3Df& p : points) {
        columns.columnOf.push_back(nearestAzimuth(columns.azimuths, azimuthOf(p)));
    }
    return columns;
}

}  // namespace offmap::rawlog
