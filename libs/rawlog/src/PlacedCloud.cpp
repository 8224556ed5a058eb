// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudColumns.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/PlacedCloud.h>

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

}  // namespace

void appendCloud(TurnScan& out, const PlacedCloud& cloud, uint32_t firstSlot,
                 const SensorConfig& config) {
    const CloudReturns returns = returnsOf(cloud.points, firstSlot, out.counts);
    const CloudColumns columns = findCloudColumns(returns.points, config.columnWidth);
    std::vector<std::vector<ColumnReturn>> byColumn(columns.azimuths.size());
    for (size_t i = 0; i < returns.points.size(); ++i) {
        byColumn[columns.columnOf[i]].push_back({returns.points[i], returns.slots[i]});
    }
    core::ScanColumn column;
    column.time = cloud.time;
    placeColumn(column, cloud.vehicle, cloud.sensorInVehicle);
    for (size_t c = 0; c < byColumn.size(); ++c) {
        column.azimuth =
            static_cast<float>(azimuthInVehicle(columns.azimuths[c], cloud.sensorInVehicle));
        appendColumn(out, column, cloud.sensorInVehicle, byColumn[c]);
    }
}

}  // namespace offmap::rawlog
