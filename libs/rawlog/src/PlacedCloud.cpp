// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ByProcessor.h>
#include <offmap/rawlog/CloudColumns.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/PlacedCloud.h>

#include <numeric>
#include <span>
#include <vector>

namespace offmap::rawlog {

namespace {

/// Whether all of some points are clearly returns; told quickly.
OFFMAP_BY_PROCESSOR bool areReturns(const CloudPoints& points) {
    uint32_t others = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        others += !isClearlyReturn(points.x[i], points.y[i], points.z[i]);
    }
    return others == 0;
}

/// The points that are returns, and their slots in the turn. Mostly, all of them are: then nothing
/// is copied.
class CloudReturns {
 public:
    CloudReturns(const CloudPoints& points, uint32_t firstSlot, ReturnCounts& counts)
        : points_(points), firstSlot_(firstSlot) {
        if (areReturns(points)) {
            counts.returns += points.size();
            return;
        }
        for (uint32_t i = 0; i < points.size(); ++i) {
            if (!countReturn(counts, points[i])) continue;
            some_.add(points[i]);
            slots_.push_back(firstSlot + i);
        }
        points_ = some_.points();
    }
    CloudReturns(const CloudReturns&) = delete;
    CloudReturns& operator=(const CloudReturns&) = delete;

    const CloudPoints& points() const { return points_; }
    PointSlots slots() const { return {firstSlot_, slots_}; }

 private:
    CloudPoints points_;
    uint32_t firstSlot_;
    CloudArrays some_;
    std::vector<uint32_t> slots_;  // of some_
};

/// The runs column after column, and where each column ends.
struct ColumnOrder {
    std::vector<ColumnRun> runs;
    std::vector<uint32_t> ends;
};

ColumnOrder orderOf(const CloudColumns& columns) {
    ColumnOrder order{std::vector<ColumnRun>(columns.runs.size()),
                      std::vector<uint32_t>(columns.azimuths.size() + 1, 0)};
    auto& [runs, ends] = order;
    for (const ColumnRun& run : columns.runs) ++ends[run.column + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    // Now ends[c] is where column c begins, and moves to its end as it is filled.
    for (const ColumnRun& run : columns.runs) runs[ends[run.column]++] = run;
    ends.pop_back();
    return order;
}

/// The column that some runs are; gathered only if they are several or not in order.
void appendRuns(TurnScan& out, const core::ScanColumn& column,
                const mrpt::poses::CPose3D& sensorInVehicle, const CloudReturns& returns,
                std::span<const ColumnRun> runs) {
    const CloudPoints& points = returns.points();
    const PointSlots slots = returns.slots();
    if (runs.size() == 1 && appendColumnInOrder(out, column, sensorInVehicle, points, slots,
                                                runs[0].begin, runs[0].end)) {
        return;
    }
    const size_t begin = out.scan.points.size();
    out.scan.columns.push_back(column);
    for (const ColumnRun& run : runs) {
        for (uint32_t i = run.begin; i < run.end; ++i) out.add(points[i], slots[i]);
    }
    closeColumn(out, sensorInVehicle, begin);
}

}  // namespace

void appendCloud(TurnScan& out, const PlacedCloud& cloud, uint32_t firstSlot,
                 const SensorConfig& config) {
    const CloudReturns returns(cloud.points, firstSlot, out.counts);
    const CloudColumns columns = findCloudColumns(returns.points(), config.columnWidth);
    const ColumnOrder order = orderOf(columns);
    out.reserve(columns.azimuths.size(), returns.points().size());
    core::ScanColumn column;
    column.time = cloud.time;
    placeColumn(column, cloud.vehicle, cloud.sensorInVehicle);
    uint32_t next = 0;
    for (size_t c = 0; c < order.ends.size(); ++c) {
        column.azimuth =
            static_cast<float>(azimuthInVehicle(columns.azimuths[c], cloud.sensorInVehicle));
        const auto runs = std::span(order.runs).subspan(next, order.ends[c] - next);
        next = order.ends[c];
        appendRuns(out, column, cloud.sensorInVehicle, returns, runs);
    }
}

}  // namespace offmap::rawlog
