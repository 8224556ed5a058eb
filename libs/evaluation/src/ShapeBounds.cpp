// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Shapes.h>

#include <cmath>
#include <limits>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;

/// Rounding must not let a ray slip by an edge. [m]
constexpr double slack = 1e-6;

}  // namespace

bool BoundingCircle::mayMeet(const Ray& ray) const {
    const TPoint2D direction(ray.direction.x, ray.direction.y);
    const TPoint2D toCentre = centre - TPoint2D(ray.origin.x, ray.origin.y);
    // both times the length of the direction in top view
    const double aside = direction.x * toCentre.y - direction.y * toCentre.x;
    const double ahead = direction.x * toCentre.x + direction.y * toCentre.y;
    const double squared =
        radius * radius * (direction.x * direction.x + direction.y * direction.y);
    return !(aside * aside > squared) && (ahead >= 0 || ahead * ahead <= squared);
}

BoundingCircle boundsOf(const Panel& panel) {
    const TPoint2D middle = (panel.line.point1 + panel.line.point2) * 0.5;
    return {middle, 0.5 * panel.line.length() + slack};
}

BoundingCircle boundsOf(const Mesh& mesh) { return boundsOf(mesh.panel); }

BoundingCircle boundsOf(const Plane& /*plane*/) {
    return {{0, 0}, std::numeric_limits<double>::infinity()};
}

BoundingCircle boundsOf(const Cylinder& cylinder) {
    const TPoint2D halfLean = cylinder.lean * (0.5 * cylinder.height.width());
    return {cylinder.centre + halfLean, halfLean.norm() + cylinder.radius + slack};
}

BoundingCircle boundsOf(const Box& box) {
    return {{box.centre.x, box.centre.y}, 0.5 * std::hypot(box.length, box.width) + slack};
}

}  // namespace offmap::evaluation
