// SPDX-License-Identifier: BSD-3-Clause
#include "ElevationOrder.h"
#include "WrappedAngle.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/rawlog/ColumnBuilder.h>

#include <algorithm>
#include <cmath>

namespace offmap::rawlog {

namespace {

OFFMAP_BY_PROCESSOR void copyPoints(const CloudPoints& from, mrpt::math::TPoint3Df* __restrict to) {
    const float *x = from.x.data(), *y = from.y.data(), *z = from.z.data();
    for (size_t i = 0; i < from.size(); ++i) {
        to[i].x = x[i];
        to[i].y = y[i];
        to[i].z = z[i];
    }
}

/// The last column has the last points, from `begin` on.
void setRange(core::OrganizedScan& scan, size_t begin) {
    scan.columns.back().begin = static_cast<uint32_t>(begin);
    scan.columns.back().end = static_cast<uint32_t>(scan.points.size());
}

void turnRound(core::OrganizedScan& scan, size_t begin) {
    std::ranges::reverse(std::span(scan.points).subspan(begin));
    std::ranges::reverse(std::span(scan.sourceIndex).subspan(begin));
}

/// Sorts the last returns that there are, from `begin` on, and leaves duplicates out.
void sortUpward(TurnScan& out, size_t begin, const Upwards& up) {
    std::vector<mrpt::math::TPoint3Df>& points = out.scan.points;
    std::vector<uint32_t>& sourceIndex = out.scan.sourceIndex;
    std::vector<ColumnReturn> returns;
    for (size_t i = begin; i < points.size(); ++i) returns.push_back({points[i], sourceIndex[i]});
    sortUpward(returns, up);
    auto end = static_cast<uint32_t>(begin);
    for (const ColumnReturn& r : returns) {
        if (end > begin && points[end - 1] == r.point) {
            ++out.counts.duplicates;
            out.duplicates.push_back({r.slot, end - 1});
            continue;
        }
        points[end] = r.point;
        sourceIndex[end++] = r.slot;
    }
    points.resize(end);
    sourceIndex.resize(end);
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
    if (upright) return wrapped(azimuthInSensor + sensorInVehicle.yaw());
    const double x = std::cos(azimuthInSensor), y = std::sin(azimuthInSensor);
    return std::atan2(rotation(1, 0) * x + rotation(1, 1) * y,
                      rotation(0, 0) * x + rotation(0, 1) * y);
}

void closeColumn(TurnScan& out, const mrpt::poses::CPose3D& sensorInVehicle, size_t begin) {
    const Upwards up(sensorInVehicle);
    const ElevationOrder order = elevationOrderOf(std::span(out.scan.points).subspan(begin), up);
    if (order == ElevationOrder::Downward) turnRound(out.scan, begin);
    if (order == ElevationOrder::Mixed) sortUpward(out, begin, up);
    setRange(out.scan, begin);
}

void appendColumn(TurnScan& out, const core::ScanColumn& column,
                  const mrpt::poses::CPose3D& sensorInVehicle,
                  std::span<const ColumnReturn> returns) {
    const size_t begin = out.scan.points.size();
    out.scan.columns.push_back(column);
    for (const ColumnReturn& r : returns) out.add(r.point, r.slot);
    closeColumn(out, sensorInVehicle, begin);
}

bool appendColumnInOrder(TurnScan& out, const core::ScanColumn& column,
                         const mrpt::poses::CPose3D& sensorInVehicle, const CloudPoints& points,
                         const PointSlots& slots, uint32_t begin, uint32_t end) {
    const CloudPoints ofColumn = points.subspan(begin, end - begin);
    const ElevationOrder order = elevationOrderOf(ofColumn, Upwards(sensorInVehicle));
    if (order == ElevationOrder::Mixed) return false;

    const size_t before = out.scan.points.size();
    out.scan.points.resize(before + ofColumn.size());
    out.scan.sourceIndex.resize(before + ofColumn.size());
    copyPoints(ofColumn, out.scan.points.data() + before);
    uint32_t* slot = out.scan.sourceIndex.data() + before;
    for (uint32_t i = begin; i < end; ++i) *slot++ = slots[i];
    if (order == ElevationOrder::Downward) turnRound(out.scan, before);
    out.scan.columns.push_back(column);
    setRange(out.scan, before);
    return true;
}

}  // namespace offmap::rawlog
