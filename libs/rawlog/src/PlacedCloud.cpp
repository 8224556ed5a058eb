// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudColumns.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/PlacedCloud.h>

#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace offmap::rawlog {

using mrpt::math::TPoint3Df;

namespace {

/// The points that are returns, and their slots in the turn.
struct CloudReturns {
    std::vector<TPoint3Df> points;
    std::vector<uint32_t> slots;
};

CloudReturns returnsOf(std::span<const TPoint3Df> points, uint32_t firstSlot,
                       ReturnCounts& counts) {
    CloudReturns returns;
    returns.points.reserve(points.size());
    returns.slots.reserve(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        if (!countReturn(counts, points[i])) continue;
        returns.points.push_back(points[i]);
        returns.slots.push_back(firstSlot + static_cast<uint32_t>(i));
    }
    return returns;
}

/// All returns, column after column, and where each column ends.
struct SortedReturns {
    std::vector<ColumnReturn> returns;
    std::vector<uint32_t> ends;
};

SortedReturns byColumn(const CloudReturns& from, const CloudColumns& columns) {
    std::vector<uint32_t> ends(columns.azimuths.size() + 1, 0);
    for (const uint32_t column : columns.columnOf) ++ends[column + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    // Now ends[c] is where column c begins, and moves to its end as it is filled.
    SortedReturns sorted;
    sorted.returns.resize(from.points.size());
    for (size_t i = 0; i < from.points.size(); ++i) {
        sorted.returns[ends[columns.columnOf[i]]++] = {from.points[i], from.slots[i]};
    }
    ends.pop_back();
    sorted.ends = std::move(ends);
    return sorted;
}

}  // namespace

void appendCloud(TurnScan& out, const PlacedCloud& cloud, uint32_t firstSlot,
                 const SensorConfig& config) {
    const CloudReturns returns = returnsOf(cloud.points, firstSlot, out.counts);
    const CloudColumns columns = findCloudColumns(returns.points, config.columnWidth);
    SortedReturns sorted = byColumn(returns, columns);
    out.scan.points.reserve(out.scan.points.size() + returns.points.size());
    out.scan.sourceIndex.reserve(out.scan.sourceIndex.size() + returns.points.size());
    core::ScanColumn column;
    column.time = cloud.time;
    placeColumn(column, cloud.vehicle, cloud.sensorInVehicle);
    size_t begin = 0;
    for (size_t c = 0; c < sorted.ends.size(); ++c) {
        column.azimuth =
            static_cast<float>(azimuthInVehicle(columns.azimuths[c], cloud.sensorInVehicle));
        appendColumn(out, column, cloud.sensorInVehicle,
                     std::span(sorted.returns).subspan(begin, sorted.ends[c] - begin));
        begin = sorted.ends[c];
    }
}

}  // namespace offmap::rawlog
