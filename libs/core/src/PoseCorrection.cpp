// SPDX-License-Identifier: BSD-3-Clause
#include "RootOfSquares.h"

#include <offmap/core/PoseCorrection.h>

#include <cmath>
#include <optional>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

/// How far leaning by one radian about an axis moves what is seen at a height of one metre.
TPoint2D leanAbout(const TPoint2D& axis) { return {axis.y, -axis.x}; }

TPoint2D left(const TPoint2D& p) { return {-p.y, p.x}; }

ColumnPlace placeOf(const mrpt::poses::CPose3D& sensorInMap,
                    const mrpt::math::CMatrixDouble33& mounting) {
    const auto& inMap = sensorInMap.getRotationMatrix();
    // First column of inMap * mounting^T: the vehicle's x axis.
    double x = 0, y = 0;
    for (int k = 0; k < 3; ++k) {
        x += inMap(0, k) * mounting(0, k);
        y += inMap(1, k) * mounting(0, k);
    }
    const double norm = rootOfSquares(x, y);
    const TPoint2D along = norm > 0 ? TPoint2D(x / norm, y / norm) : TPoint2D(1, 0);
    return {{sensorInMap.x(), sensorInMap.y()}, along};
}

double dot(const TPoint2D& a, const TPoint2D& b) { return a.x * b.x + a.y * b.y; }

/// To the bit; MRPT's own comparison wraps the angles first.
bool isSame(const mrpt::math::TPose3D& a, const mrpt::math::TPose3D& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.yaw == b.yaw && a.pitch == b.pitch &&
           a.roll == b.roll;
}

}  // namespace

ColumnPlace placeOf(const ScanColumn& column) {
    return placeOf(column.sensor->sensorInMap,
                   mrpt::poses::CPose3D(column.sensorInVehicle).getRotationMatrix());
}

void addPlaces(const OrganizedScan& scan, std::vector<ColumnPlace>& places) {
    std::optional<mrpt::math::TPose3D> mounting;  // that `rotation` is of: mostly, all are alike
    mrpt::math::CMatrixDouble33 rotation;
    while (places.size() < scan.columns.size()) {
        const ScanColumn& column = scan.columns[places.size()];
        if (!column.sensor) {
            places.push_back({{0, 0}, {1, 0}});
            continue;
        }
        if (!mounting || !isSame(*mounting, column.sensorInVehicle)) {
            mounting = column.sensorInVehicle;
            rotation = mrpt::poses::CPose3D(*mounting).getRotationMatrix();
        }
        places.push_back(placeOf(column.sensor->sensorInMap, rotation));
    }
}

Turn::Turn(const PoseCorrection& correction)
    : cosine(std::cos(correction.mean[2])), sine(std::sin(correction.mean[2])) {}

CorrectedColumn::CorrectedColumn(const PoseCorrection& correction, const Turn& turn,
                                 const ColumnPlace& column)
    : cosine_(turn.cosine), sine_(turn.sine) {
    const TPoint2D along = column.vehicleAlong, across = left(along);
    const double leanX = correction.mean[3], leanY = correction.mean[4];
    centre_ = correction.pivot + TPoint2D(correction.mean[0], correction.mean[1]);
    sensor_ = centre_ + turned(column.position - correction.pivot);
    perLeanX_ = turned(leanAbout(along));
    perLeanY_ = turned(leanAbout(across));
    leanPerHeight_ = perLeanX_ * leanX + perLeanY_ * leanY;
    risePerGround_ = left(along) * leanX + left(across) * leanY;
}

Vector5 CorrectedColumn::gradient(const SeenPoint& point, const TPoint2D& normal) const {
    Vector5 out;
    out << normal.x, normal.y, dot(normal, left(place(point) - centre_)),
        point.z * dot(normal, perLeanX_), point.z * dot(normal, perLeanY_);
    return out;
}

LinearDistance CorrectedColumn::distanceBehind(const TPoint2D& through,
                                               const TPoint2D& normal) const {
    return {dot(normal, sensor_ - through),
            {cosine_ * normal.x + sine_ * normal.y, cosine_ * normal.y - sine_ * normal.x},
            dot(normal, leanPerHeight_)};
}

TPoint2D PoseCorrection::apply(const ColumnPlace& column, const SeenPoint& point) const {
    return CorrectedColumn(*this, column).place(point);
}

Vector5 PoseCorrection::gradient(const ColumnPlace& column, const SeenPoint& point,
                                 const TPoint2D& normal) const {
    return CorrectedColumn(*this, column).gradient(point, normal);
}

}  // namespace offmap::core
