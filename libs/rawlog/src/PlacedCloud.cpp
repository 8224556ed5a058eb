// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudColumns.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/PlacedCloud.h>

#include <numeric>
#include <span>
#include <vector>

namespace offmap::rawlog {

using mrpt::math::TPoint3Df;

namespace {

/// The points that are returns, and their slots in the turn. Mostly, all of them are: then nothing
/// is copied.
class CloudReturns {
 public:
    CloudReturns(std::span<const TPoint3Df> points, uint32_t firstSlot, ReturnCounts& counts)
        : points_(points), firstSlot_(firstSlot) {
        const uint64_t before = counts.returns;
        for (const TPoint3Df& point : points) countReturn(counts, point);
        if (counts.returns - before == points.size()) return;
        ReturnCounts again;
        for (uint32_t i = 0; i < points.size(); ++i) {
            if (!countReturn(again, points[i])) continue;
            some_.push_back(points[i]);
            slots_.push_back(firstSlot + i);
        }
        points_ = some_;
    }
    CloudReturns(const CloudReturns&) = delete;
    CloudReturns& operator=(const CloudReturns&) = delete;

    std::span<const TPoint3Df> points() const { return points_; }
    uint32_t slot(uint32_t i) const { return slots_.empty() ? firstSlot_ + i : slots_[i]; }

 private:
    std::span<const TPoint3Df> points_;
    uint32_t firstSlot_;
    std::vector<TPoint3Df> some_;
    std::vector<uint32_t> slots_;  // of some_
};

/// The returns column after column, and where each column ends.
struct ColumnOrder {
    std::vector<uint32_t> returns, ends;
};

ColumnOrder orderOf(const CloudColumns& columns) {
    ColumnOrder order{std::vector<uint32_t>(columns.columnOf.size()),
                      std::vector<uint32_t>(columns.azimuths.size() + 1, 0)};
    auto& [returns, ends] = order;
    for (const uint32_t column : columns.columnOf) ++ends[column + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    // Now ends[c] is where column c begins, and moves to its end as it is filled.
    for (uint32_t i = 0; i < returns.size(); ++i) returns[ends[columns.columnOf[i]]++] = i;
    ends.pop_back();
    return order;
}

}  // namespace

void appendCloud(TurnScan& out, const PlacedCloud& cloud, uint32_t firstSlot,
                 const SensorConfig& config) {
    const CloudReturns returns(cloud.points, firstSlot, out.counts);
    const auto points = returns.points();
    const CloudColumns columns = findCloudColumns(points, config.columnWidth);
    const ColumnOrder order = orderOf(columns);
    out.scan.points.reserve(out.scan.points.size() + points.size());
    out.scan.sourceIndex.reserve(out.scan.sourceIndex.size() + points.size());
    core::ScanColumn column;
    column.time = cloud.time;
    placeColumn(column, cloud.vehicle, cloud.sensorInVehicle);
    std::vector<ColumnReturn> ofColumn;
    uint32_t next = 0;
    for (size_t c = 0; c < order.ends.size(); ++c) {
        column.azimuth =
            static_cast<float>(azimuthInVehicle(columns.azimuths[c], cloud.sensorInVehicle));
        ofColumn.clear();
        for (; next < order.ends[c]; ++next) {
            const uint32_t i = order.returns[next];
            ofColumn.push_back({points[i], returns.slot(i)});
        }
        appendColumn(out, column, cloud.sensorInVehicle, ofColumn);
    }
}

}  // namespace offmap::rawlog
