// SPDX-License-Identifier: BSD-3-Clause
#include "AzimuthArcs.h"
#include "AzimuthClusters.h"
#include "NearestColumn.h"

#include <offmap/rawlog/CloudColumns.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace offmap::rawlog {

namespace {

constexpr double fullTurn = 2.0 * std::numbers::pi;
constexpr double pointsPerColumn = 32;

/// Adds points from `begin` on, where the last run ends, up to `end`.
void addRun(std::vector<ColumnRun>& runs, uint32_t column, uint32_t begin, uint32_t end) {
    const bool goesOn = !runs.empty() && runs.back().column == column;
    if (goesOn) {
        runs.back().end = end;
    } else {
        runs.push_back({column, begin, end});
    }
}

double chosenWidth(size_t pointCount) {
    const double even = fullTurn * pointsPerColumn / std::max(1.0, static_cast<double>(pointCount));
    return std::clamp(even, mrpt::DEG2RAD(0.2), mrpt::DEG2RAD(2.0));
}

/// Bins that hold no point are left out.
CloudColumns fixedBins(const CloudPoints& points, double width) {
    const auto bins = static_cast<uint32_t>(std::max(1.0, std::round(fullTurn / width)));
    const double exactWidth = fullTurn / bins;
    CloudColumns columns;
    std::vector<uint8_t> used(bins, 0);
    for (uint32_t i = 0; i < points.size(); ++i) {
        const double fromStart =
            (azimuthOf(points.x[i], points.y[i]) + std::numbers::pi) / exactWidth;
        const uint32_t bin = std::min(bins - 1, static_cast<uint32_t>(fromStart));
        addRun(columns.runs, bin, i, i + 1);
        used[bin] = 1;
    }
    std::vector<uint32_t> columnOfBin(bins, 0);
    for (uint32_t b = 0; b < bins; ++b) {
        columnOfBin[b] = static_cast<uint32_t>(columns.azimuths.size());
        if (used[b]) columns.azimuths.push_back((b + 0.5) * exactWidth - std::numbers::pi);
    }
    for (ColumnRun& run : columns.runs) run.column = columnOfBin[run.column];
    return columns;
}

/// The points that are clearly nearest to one column, told without their azimuths.
class NearColumn {
 public:
    /// \param reach [rad] how far off the azimuth they may look
    NearColumn(double azimuth, double reach)
        : x_(std::cos(azimuth)), y_(std::sin(azimuth)), slope_(std::tan(std::min(reach, 1.0))) {}

    bool has(float x, float y) const {
        return std::abs(x_ * y - y_ * x) < slope_ * (x_ * x + y_ * y);
    }

 private:
    double x_, y_, slope_;
};

/// The columns nearest to points, as runs. Those on the vertical axis stand beside others of their
/// column, mostly: then no azimuth is worked out.
void addNearest(CloudColumns& columns, NearestColumn& nearest, const CloudPoints& points,
                const AzimuthArc& arc) {
    std::optional<NearColumn> last;
    uint32_t column = 0;
    for (uint32_t i = arc.first; i < arc.end; ++i) {
        const float x = points.x[i], y = points.y[i];
        if (!last || !last->has(x, y)) {
            column = nearest.of(azimuthOf(x, y));
            last.emplace(columns.azimuths[column], nearest.reach(column));
        }
        addRun(columns.runs, column, i, i + 1);
    }
}

/// The column that is nearest to all that looks as an arc does, if one is.
std::optional<uint32_t> columnOf(const AzimuthArc& arc, NearestColumn& nearest) {
    const uint32_t column = nearest.of(arc.begin);
    const bool whole = column == nearest.of(wrapped(arc.begin + arc.length));
    return whole ? std::optional(column) : std::nullopt;
}

/// The column nearest to each point. Where all of an arc has the same, nothing is calculated.
CloudColumns nearestColumns(const CloudPoints& points, std::vector<double> azimuths,
                            const std::vector<AzimuthArc>& arcs) {
    CloudColumns columns{std::move(azimuths), {}};
    NearestColumn nearest(columns.azimuths);
    for (const AzimuthArc& arc : arcs) {
        const auto column = columnOf(arc, nearest);
        if (column && arc.points == arc.end - arc.first) {
            addRun(columns.runs, *column, arc.first, arc.end);
        } else {
            addNearest(columns, nearest, points, arc);
        }
    }
    return columns;
}

/// The same for points in whatever order.
CloudColumns nearestColumns(const CloudPoints& points, std::vector<double> azimuths,
                            const BinnedArcs& binned) {
    CloudColumns columns{std::move(azimuths), {}};
    NearestColumn nearest(columns.azimuths);
    std::vector<std::optional<uint32_t>> ofArc;
    ofArc.reserve(binned.arcs.size());
    for (const AzimuthArc& arc : binned.arcs) ofArc.push_back(columnOf(arc, nearest));
    for (uint32_t i = 0; i < points.size(); ++i) {
        const uint32_t arc = binned.arcOf[i];
        const auto known = arc == BinnedArcs::none ? std::nullopt : ofArc[arc];
        const uint32_t column = known ? *known : nearest.of(azimuthOf(points.x[i], points.y[i]));
        addRun(columns.runs, column, i, i + 1);
    }
    return columns;
}

bool beginsBefore(const AzimuthArc& a, const AzimuthArc& b) { return a.begin < b.begin; }

/// Those of a scanner stand so but for where its turn begins and which way round it goes.
std::vector<AzimuthArc> sorted(std::vector<AzimuthArc> arcs) {
    if (arcs.size() > 1 && beginsBefore(arcs[1], arcs[0])) std::reverse(arcs.begin(), arcs.end());
    const auto first = std::min_element(arcs.begin(), arcs.end(), beginsBefore);
    std::rotate(arcs.begin(), first, arcs.end());
    if (!std::is_sorted(arcs.begin(), arcs.end(), beginsBefore)) {
        std::sort(arcs.begin(), arcs.end(), beginsBefore);
    }
    return arcs;
}

/// From those that are sure; if that blurs the columns, from those that are clear.
std::vector<double> clustersOf(const std::vector<AzimuthArc>& arcs) {
    std::vector<AzimuthArc> chosen = arcs;
    std::erase_if(chosen, [](const AzimuthArc& arc) { return !arc.isSure(); });
    chosen = sorted(std::move(chosen));
    std::vector<double> clusters = findClusters(chosen);
    if (!clusters.empty()) return clusters;
    const auto unclear = std::erase_if(chosen, [](const AzimuthArc& arc) { return !arc.clear; });
    return unclear > 0 ? findClusters(chosen) : clusters;
}

}  // namespace

CloudColumns findCloudColumns(const CloudPoints& points, double width) {
    if (width > 0) return fixedBins(points, width);
    const std::vector<AzimuthArc> arcs = arcsInOrder(points);
    std::vector<double> clusters = clustersOf(arcs);
    if (!clusters.empty()) return nearestColumns(points, std::move(clusters), arcs);
    const BinnedArcs binned = arcsInBins(points);
    clusters = clustersOf(binned.arcs);
    if (clusters.empty()) return fixedBins(points, chosenWidth(points.size()));
    return nearestColumns(points, std::move(clusters), binned);
}

}  // namespace offmap::rawlog
