// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ColumnBuilder.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace offmap::rawlog {

using mrpt::math::TPoint3Df;

namespace {

double squaredRange(const TPoint3Df& p) {
    const double x = p.x, y = p.y, z = p.z;
    return x * x + y * y + z * z;
}

bool comesFirst(const ColumnReturn& a, const ColumnReturn& b) {  // of two at one elevation
    const auto key = [](const ColumnReturn& r) {
        return std::make_tuple(squaredRange(r.point), r.point.x, r.point.y, r.point.z, r.slot);
    };
    return key(a) < key(b);
}

struct Below {  // a type, so that what sorts knows it
    bool operator()(const ColumnReturn& a, const ColumnReturn& b) const {
        if (a.sinElevation != b.sinElevation) return a.sinElevation < b.sinElevation;
        return comesFirst(a, b);
    }
};

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
    const auto& rotation = sensorInVehicle.getRotationMatrix();
    const double upX = rotation(2, 0), upY = rotation(2, 1), upZ = rotation(2, 2);
    for (ColumnReturn& r : returns) {
        const double height = upX * r.point.x + upY * r.point.y + upZ * r.point.z;
        r.sinElevation = height / std::sqrt(squaredRange(r.point));
    }
    const bool inOrder = std::is_sorted(returns.begin(), returns.end(), Below());
    if (!inOrder) std::sort(returns.begin(), returns.end(), Below());

    column.begin = static_cast<uint32_t>(out.scan.points.size());
    for (const ColumnReturn& r : returns) {
        if (out.scan.points.size() > column.begin && out.scan.points.back() == r.point) {
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

}  // namespace offmap::rawlog
