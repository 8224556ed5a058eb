// SPDX-License-Identifier: BSD-3-Clause
#include "ElevationOrder.h"

#include <offmap/rawlog/ColumnBuilder.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace offmap::rawlog {

namespace {

/// Whether returns stand in order, once those that stand from top to bottom are turned round.
bool turnUpward(std::span<ColumnReturn> returns, const Upwards& up) {
    if (standUpward(returns, up)) return true;
    if (!standUpward(returns, up.reversed())) return false;
    std::reverse(returns.begin(), returns.end());
    return true;
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

    column.begin = static_cast<uint32_t>(out.scan.points.size());
    for (const ColumnReturn& r : returns) {
        if (!inOrder && out.scan.points.size() > column.begin &&
            out.scan.points.back() == r.point) {
            ++out.counts.duplicates;
            out.duplicates.push_back({r.slot, static_cast<uint32_t>(out.scan.points.size() - 1)});
            continue;
        }
        out.scan.points.push_back(r.point);
        out.scan.sourceIndex.push_back(r.slot);
    }
    column.end = static_cast<uint32_t>(out.scan.points.size());
    out.scan.columns.push_back(column);
}

bool appendColumnInOrder(TurnScan& out, core::ScanColumn column,
                         const mrpt::poses::CPose3D& sensorInVehicle, const CloudPoints& points,
                         const PointSlots& slots, uint32_t begin, uint32_t end) {
    const CloudPoints ofColumn = points.subspan(begin, end - begin);
    const Upwards up(sensorInVehicle);
    const bool upward = standUpward(ofColumn, up);
    if (!upward && !standUpward(ofColumn, up.reversed())) return false;

    const size_t before = out.scan.points.size();
    out.scan.points.resize(before + ofColumn.size());
    out.scan.sourceIndex.resize(before + ofColumn.size());
    const auto copied = std::span(out.scan.points).subspan(before);
    const auto slot = std::span(out.scan.sourceIndex).subspan(before);
    for (size_t i = 0; i < ofColumn.size(); ++i) copied[i] = ofColumn[i];
    for (uint32_t i = begin; i < end; ++i) slot[i - begin] = slots[i];
    if (!upward) {
        std::ranges::reverse(copied);
        std::ranges::reverse(slot);
    }
    column.begin = static_cast<uint32_t>(before);
    column.end = static_cast<uint32_t>(out.scan.points.size());
    out.scan.columns.push_back(column);
    return true;
}

}  // namespace offmap::rawlog
