// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Shapes.h>

#include <algorithm>
#include <cmath>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

const TVector3D upwards(0, 0, 1);

double toTopOrBottom(const core::Interval& height, double z) {
    return std::min(std::abs(z - height.min()), std::abs(z - height.max()));
}

}  // namespace

TVector3D normalAt(const Panel& panel, const TPoint3D& /*point*/) {
    const TPoint2D along = panel.line.point2 - panel.line.point1;
    return TVector3D(-along.y, along.x, 0) * (1 / along.norm());
}

TVector3D normalAt(const Mesh& mesh, const TPoint3D& point) { return normalAt(mesh.panel, point); }

TVector3D normalAt(const Plane& /*plane*/, const TPoint3D& /*point*/) { return upwards; }

TVector3D normalAt(const Cylinder& cylinder, const TPoint3D& point) {
    const double z = point.z - cylinder.height.min();
    const TPoint2D fromAxis = TPoint2D(point.x, point.y) - cylinder.centre - cylinder.lean * z;
    const double toSide = std::abs(fromAxis.norm() - cylinder.radius);
    if (toTopOrBottom(cylinder.height, point.z) < toSide) return upwards;
    // gradient of |fromAxis|^2
    const double rise = -(fromAxis.x * cylinder.lean.x + fromAxis.y * cylinder.lean.y);
    return TVector3D(fromAxis.x, fromAxis.y, rise).unitarize();
}

TVector3D normalAt(const Box& box, const TPoint3D& point) {
    const TVector3D x(std::cos(box.centre.phi), std::sin(box.centre.phi), 0), y(-x.y, x.x, 0);
    const double dx = point.x - box.centre.x, dy = point.y - box.centre.y;
    const double toEnd = std::abs(std::abs(dx * x.x + dy * x.y) - box.length / 2);
    const double toSide = std::abs(std::abs(dx * y.x + dy * y.y) - box.width / 2);
    if (toTopOrBottom(box.height, point.z) < std::min(toEnd, toSide)) return upwards;
    return toEnd < toSide ? x : y;
}

}  // namespace offmap::evaluation
