// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/PoseCorrection.h>

#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

struct Rotation {
    explicit Rotation(double angle) : c(std::cos(angle)), s(std::sin(angle)) {}
    TPoint2D operator*(const TPoint2D& p) const { return {c * p.x - s * p.y, s * p.x + c * p.y}; }
    double c, s;
};

/// How far leaning by one radian about an axis moves what is seen at a height of one metre.
TPoint2D leanAbout(const TPoint2D& axis) { return {axis.y, -axis.x}; }

TPoint2D left(const TPoint2D& p) { return {-p.y, p.x}; }

double dot(const TPoint2D& a, const TPoint2D& b) { return a.x * b.x + a.y * b.y; }

}  // namespace

ColumnPlace placeOf(const ScanColumn& column) {
    const auto& sensor = column.sensor->sensorInMap;
    const auto& inMap = sensor.getRotationMatrix();
    const auto mounting = mrpt::poses::CPose3D(column.sensorInVehicle).getRotationMatrix();
    // First column of inMap * mounting^T: the vehicle's x axis.
    double x = 0, y = 0;
    for (int k = 0; k < 3; ++k) {
        x += inMap(0, k) * mounting(0, k);
        y += inMap(1, k) * mounting(0, k);
    }
    const double norm = std::hypot(x, y);
    const TPoint2D along = norm > 0 ? TPoint2D(x / norm, y / norm) : TPoint2D(1, 0);
    return {{sensor.x(), sensor.y()}, along};
}

TPoint2D PoseCorrection::apply(const ColumnPlace& column, const SeenPoint& point) const {
    const TPoint2D along = column.vehicleAlong;
    const TPoint2D lean = leanAbout(along) * mean[3] + leanAbout(left(along)) * mean[4];
    const TPoint2D fromPivot = column.position + point.ground + lean * point.z - pivot;
    return pivot + TPoint2D(mean[0], mean[1]) + Rotation(mean[2]) * fromPivot;
}

Vector5 PoseCorrection::gradient(const ColumnPlace& column, const SeenPoint& point,
                                 const TPoint2D& normal) const {
    const TPoint2D fromPivot = apply(column, point) - pivot - TPoint2D(mean[0], mean[1]);
    const Rotation turn(mean[2]);
    const TPoint2D along = column.vehicleAlong;
    Vector5 out;
    out << normal.x, normal.y, dot(normal, left(fromPivot)),
        point.z * dot(normal, turn * leanAbout(along)),
        point.z * dot(normal, turn * leanAbout(left(along)));
    return out;
}

}  // namespace offmap::core
