// SPDX-License-Identifier: BSD-3-Clause
#include "ElevationOrder.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/rawlog/ColumnBuilder.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace offmap::rawlog {

namespace {

/// Whether returns stand in order, once those that stand from top to bottom are turned round.
bool turnUpward(std::span<ColumnReturn> returns, const Upwards& up) {
    const ElevationOrder order = elevationOrderOf(returns, up);
    if (order == ElevationOrder::Downward) std::reverse(returns.begin(), returns.end());
    return order != ElevationOrder::Mixed;
}

OFFMAP_BY_PROCESSOR void copyPoints(const CloudPoints& from, mrpt::math::TPoint3Df* __restrict to) {
    const float *x = from.x.data(), *y = from.y.data(), *z = from.z.data();
    for (size_t i = 0; i < from.size(); ++i) {
        to[i].x = x[i];
        to[i].y = y[i];
        to[i].z = z[i];
    }
}

}  // namespace

void placeColumn(core::ScanColumn& column, const PoseLookup& vehicle,
                 const mrpt::poses::CPose3D& sensorInVehicle) {
    column.sensorInVehicle = sensorInVehicle.asTPose();
    column.fault = vehicle.fault;
    if (vehicle.vehicleInMap) {
        column.sensor =
            core::composeOnGround(*vehicle.vehicleInMap, vehicle.groundCovariance, sensorInVehicle);
    }
}

double azimuthInVehicle(double azimuthInSensor, const mrpt::poses::CPose3D& sensorInVehicle) {
    const auto& rotation = sensorInVehicle.getRotationMatrix();
    const bool upright = rotation(2, 2) == 1;
    if (upright) return mrpt::math::wrapToPi(azimuthInSensor + sensorInVehicle.yaw());
    const double x = std::cos(azimuthInSensor), y = std::sin(azimuthInSensor);
    return std::atan2(rotation(1, 0) * x + rotation(1, 1) * y,
                      rotation(0, 0) * x + rotation(0, 1) * y);
}

void appendColumn(TurnScan& out, core::ScanColumn column,
                  const mrpt::poses::CPose3D& sensorInVehicle, std::span<ColumnReturn> returns) {
    const Upwards up(sensorInVehicle);
    const bool inOrder = turnUpward(returns, up);
    if (!inOrder) sortUpward(returns, up);

    const auto begin = static_cast<uint32_t>(out.scan.points.size());
    out.scan.points.resize(begin + returns.size());
    out.scan.sourceIndex.resize(begin + returns.size());
    uint32_t end = begin;
    for (const ColumnReturn& r : returns) {
        if (!inOrder && end > begin && out.scan.points[end - 1] == r.point) {
            ++out.counts.duplicates;
            out.duplicates.push_back({r.slot, end - 1});
            continue;
        }
        out.scan.points[end] = r.point;
        out.scan.sourceIndex[end++] = r.slot;
    }
    out.scan.points.resize(end);
    out.scan.sourceIndex.resize(end);
    column.begin = begin;
    column.end = end;
    out.scan.columns.push_back(column);
}

bool appendColumnInOrder(TurnScan& out, core::ScanColumn column,
                         const mrpt::poses::CPose3D& sensorInVehicle, const CloudPoints& points,
                         const PointSlots& slots, uint32_t begin, uint32_t end) {
    const CloudPoints ofColumn = points.subspan(begin, end - begin);
    const ElevationOrder order = elevationOrderOf(ofColumn, Upwards(sensorInVehicle));
    if (order == ElevationOrder::Mixed) return false;

    const size_t before = out.scan.points.size();
    out.scan.points.resize(before + ofColumn.size());
    out.scan.sourceIndex.resize(before + ofColumn.size());
    const auto copied = std::span(out.scan.points).subspan(before);
    const auto slot = std::span(out.scan.sourceIndex).subspan(before);
    copyPoints(ofColumn, copied.data());
    for (uint32_t i = begin; i < end; ++i) slot[i - begin] = slots[i];
    if (order == ElevationOrder::Downward) {
        std::ranges::reverse(copied);
        std::ranges::reverse(slot);
    }
    column.begin = static_cast<uint32_t>(before);
    column.end = static_cast<uint32_t>(out.scan.points.size());
    out.scan.columns.push_back(column);
    return true;
}

}  // namespace offmap::rawlog
