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
        if (a.squaredSine != b.squaredSine) return a.squaredSine < b.squaredSine;
        return comesFirst(a, b);
    }
};

/// What is above the horizontal plane of a sensor in the vehicle's axes.
class Upwards {
 public:
    explicit Upwards(const mrpt::poses::CPose3D& sensorInVehicle) {
        const auto& rotation = sensorInVehicle.getRotationMatrix();
        x_ = rotation(2, 0), y_ = rotation(2, 1), z_ = rotation(2, 2);
    }
    /// [m^2] Square of the height, with its sign.
    double squaredHeight(const TPoint3Df& p) const {
        const double height = x_ * p.x + y_ * p.y + z_ * p.z;
        return height * std::abs(height);
    }

 private:
    double x_, y_, z_;
};

/// Whether each return stands clearly above the one before, so that rounding cannot make it look
/// otherwise. Told without divisions; mostly, they do.
bool standInOrder(std::span<const ColumnReturn> returns, const Upwards& up) {
    constexpr double rounding = 1e-12;
    double heightBefore = -1, rangeBefore = 0;  // [m^2] below anything
    for (const ColumnReturn& r : returns) {
        const double height = up.squaredHeight(r.point), range = squaredRange(r.point);
        if (!(height * rangeBefore - heightBefore * range > rounding * range * rangeBefore)) {
            return false;
        }
        heightBefore = height;
        rangeBefore = range;
    }
    return true;
}

void putInOrder(std::span<ColumnReturn> returns, const Upwards& up) {
    for (ColumnReturn& r : returns) {
        r.squaredSine = up.squaredHeight(r.point) / squaredRange(r.point);
    }
    std::sort(returns.begin(), returns.end(), Below());
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
    const bool inOrder = standInOrder(returns, up);
    if (!inOrder) putInOrder(returns, up);

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

}  // namespace offmap::rawlog
