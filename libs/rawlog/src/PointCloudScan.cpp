// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudColumns.h>
#include <offmap/rawlog/ColumnBuilder.h>
#include <offmap/rawlog/PointCloudScan.h>

#include <fmt/format.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <stdexcept>

namespace offmap::rawlog {

namespace {

using Cloud = mrpt::obs::CObservationPointCloud;
using mrpt::maps::CPointsMap;
using mrpt::math::TPoint3Df;

const Cloud& asCloud(const mrpt::obs::CObservation& obs) { return dynamic_cast<const Cloud&>(obs); }

/// The points that are returns, and their slots in the turn.
struct CloudReturns {
    std::vector<TPoint3Df> points;
    std::vector<uint32_t> slots;
};

CloudReturns returnsOf(const Cloud& obs, uint32_t firstSlot, ReturnCounts& counts) {
    CloudReturns returns;
    if (!obs.pointcloud) return returns;
    const auto& x = obs.pointcloud->getPointsBufferRef_x();
    const auto& y = obs.pointcloud->getPointsBufferRef_y();
    const auto& z = obs.pointcloud->getPointsBufferRef_z();
    returns.points.reserve(x.size());
    returns.slots.reserve(x.size());
    for (size_t i = 0; i < x.size(); ++i) {
        const TPoint3Df point(x[i], y[i], z[i]);
        if (!countReturn(counts, point)) continue;
        returns.points.push_back(point);
        returns.slots.push_back(firstSlot + static_cast<uint32_t>(i));
    }
    return returns;
}

void appendCloud(TurnScan& out, const Cloud& obs, uint32_t firstSlot, const PoseSource& poses,
                 const SensorConfig& config) {
    const mrpt::poses::CPose3D mounting = sensorInVehicle(obs, config);
    const CloudReturns returns = returnsOf(obs, firstSlot, out.counts);
    const CloudColumns columns = findCloudColumns(returns.points, config.columnWidth);
    std::vector<std::vector<ColumnReturn>> byColumn(columns.azimuths.size());
    for (size_t i = 0; i < returns.points.size(); ++i) {
        byColumn[columns.columnOf[i]].push_back({returns.points[i], returns.slots[i]});
    }
    core::ScanColumn column;
    column.time = obs.timestamp;
    placeColumn(column, poses.at(obs.timestamp), mounting);
    for (size_t c = 0; c < byColumn.size(); ++c) {
        column.azimuth = static_cast<float>(azimuthInVehicle(columns.azimuths[c], mounting));
        appendColumn(out, column, mounting, byColumn[c]);
    }
}

/// A copy of its own. Copying a map of points does not copy its options.
CPointsMap::Ptr copyOf(const CPointsMap& map) {
    auto copy = std::dynamic_pointer_cast<CPointsMap>(map.duplicateGetSmartPtr());
    copy->genericMapParams = map.genericMapParams;
    copy->insertionOptions = map.insertionOptions;
    copy->likelihoodOptions = map.likelihoodOptions;
    copy->renderOptions = map.renderOptions;
    return copy;
}

}  // namespace

size_t PointCloudScan::slotCount(const mrpt::obs::CObservation& obs) const {
    const Cloud& cloud = asCloud(obs);
    if (cloud.isExternallyStored()) {
        throw std::logic_error(fmt::format("the cloud of '{}' is still in its file '{}'",
                                           cloud.sensorLabel, cloud.getExternalStorageFile()));
    }
    return cloud.pointcloud ? cloud.pointcloud->size() : 0;
}

TurnScan PointCloudScan::organize(const Turn& turn, const PoseSource& poses,
                                  const SensorConfig& config) const {
    TurnScan out;
    size_t firstSlot = 0;
    for (const auto& obs : turn) {
        const size_t slots = slotCount(*obs);
        appendCloud(out, asCloud(*obs), static_cast<uint32_t>(firstSlot), poses, config);
        firstSlot += slots;
    }
    return out;
}

mrpt::obs::CObservation::Ptr PointCloudScan::withOnly(const mrpt::obs::CObservation& obs,
                                                      SlotMask keep,
                                                      Leftovers /*leftovers*/) const {
    checkMask(obs, keep);
    auto out = std::make_shared<Cloud>(asCloud(obs));
    if (!out->pointcloud) return out;
    std::vector<bool> leaves(keep.size());
    for (size_t i = 0; i < keep.size(); ++i) leaves[i] = !keep[i];
    out->pointcloud = copyOf(*out->pointcloud);
    out->pointcloud->applyDeletionMask(leaves);
    return out;
}

mrpt::obs::CObservation::Ptr PointCloudScan::asPointCloud(const mrpt::obs::CObservation& obs,
                                                          SlotMask keep,
                                                          const SensorConfig& /*config*/) const {
    return withOnly(obs, keep, Leftovers::Keep);
}

}  // namespace offmap::rawlog
