// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/PlacedReturns.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace offmap::view {
namespace {

struct Range1D {
    double min, max;
};

/// What is left of the values without the given share at either end.
Range1D percentiles(std::vector<float>& values, double share) {
    const auto cut = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + cut, values.end());
    const double min = values[static_cast<size_t>(cut)];
    std::nth_element(values.begin() + cut, values.end() - 1 - cut, values.end());
    return {min, *(values.end() - 1 - cut)};
}

Range1D atLeast(Range1D r, double width) {
    const double missing = std::max(0.0, width - (r.max - r.min));
    return {r.min - 0.5 * missing, r.max + 0.5 * missing};
}

Range1D extentAlong(const PlacedReturns& returns, float mrpt::math::TPoint3Df::*axis) {
    std::vector<float> all, mapped;
    all.reserve(returns.points.size());
    mapped.reserve(returns.points.size());
    for (size_t i = 0; i < returns.points.size(); ++i) {
        if (!std::isfinite(returns.points[i].*axis)) continue;
        all.push_back(returns.points[i].*axis);
        if (returns.labels[i] == core::PointLabel::Mapped) mapped.push_back(all.back());
    }
    if (all.empty()) return {0, 0};
    Range1D range = percentiles(all, 0.05);
    if (!mapped.empty()) {
        const Range1D known = percentiles(mapped, 0.01);
        range = {std::min(range.min, known.min), std::max(range.max, known.max)};
    }
    return range;
}

}  // namespace

PlacedReturns placedReturns(const core::OrganizedScan& scan,
                            std::span<const core::PointLabel> labels,
                            const std::optional<mrpt::poses::CPose3D>& fallbackSensorInMap) {
    if (labels.size() != scan.points.size())
        throw std::invalid_argument("placedReturns: one label per point of the scan is needed");
    PlacedReturns placed;
    placed.points.reserve(scan.points.size());
    placed.labels.reserve(scan.points.size());
    placed.indices.reserve(scan.points.size());
    placed.sensorPath.reserve(scan.columns.size());
    for (const core::ScanColumn& column : scan.columns) {
        if (!column.sensor && !fallbackSensorInMap) continue;
        const auto& sensorInMap = column.sensor ? column.sensor->sensorInMap : *fallbackSensorInMap;
        placed.sensorPath.push_back(sensorInMap);
        for (uint32_t i = column.begin; i < column.end; ++i) {
            placed.points.emplace_back(sensorInMap.composePoint(scan.points[i]));
            placed.labels.push_back(labels[i]);
            placed.indices.push_back(i);
        }
    }
    return placed;
}

mrpt::math::TBoundingBox extentOf(const PlacedReturns& returns) {
    using Point = mrpt::math::TPoint3Df;
    constexpr double minWidth = 2.0;  // [m]
    const Range1D x = atLeast(extentAlong(returns, &Point::x), minWidth);
    const Range1D y = atLeast(extentAlong(returns, &Point::y), minWidth);
    const Range1D z = atLeast(extentAlong(returns, &Point::z), minWidth);
    return {{x.min, y.min, z.min}, {x.max, y.max, z.max}};
}

}  // namespace offmap::view
