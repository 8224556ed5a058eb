// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Shapes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;

constexpr double inf = std::numeric_limits<double>::infinity();

double cross(const TPoint2D& a, const TPoint2D& b) { return a.x * b.y - a.y * b.x; }
double dot(const TPoint2D& a, const TPoint2D& b) { return a.x * b.x + a.y * b.y; }

/// The stretch of a ray, in distances from its origin, that lies within a convex shape.
struct Stretch {
    double begin = -inf, end = inf;

    void cutTo(double first, double last) {
        begin = std::max(begin, first);
        end = std::min(end, last);
    }
    /// Cut to where `position + t * speed` lies between two values.
    void cutToSlab(double position, double speed, double low, double high) {
        if (speed == 0) {
            if (position < low || position > high) cutTo(inf, -inf);
            return;
        }
        const double a = (low - position) / speed, b = (high - position) / speed;
        cutTo(std::min(a, b), std::max(a, b));
    }
    std::optional<double> entry() const {
        if (begin > end || begin <= 0) return std::nullopt;
        return begin;
    }
};

}  // namespace

std::optional<double> meet(const Ray& ray, const Panel& panel) {
    // Panels that share an end must not let a ray slip between them.
    constexpr double slack = 1e-12;
    const TPoint2D direction(ray.direction.x, ray.direction.y);
    const TPoint2D along = panel.line.point2 - panel.line.point1;
    const TPoint2D toPanel = panel.line.point1 - TPoint2D(ray.origin.x, ray.origin.y);
    const double det = cross(direction, along);
    if (det == 0) return std::nullopt;

    const double range = cross(toPanel, along) / det;
    const double share = cross(toPanel, direction) / det;
    const double z = ray.origin.z + range * ray.direction.z;
    if (range <= 0 || share < -slack || share > 1 + slack || !panel.height.contains(z)) {
        return std::nullopt;
    }
    return range;
}

std::optional<double> meet(const Ray& ray, const Mesh& mesh) {
    const std::optional<double> range = meet(ray, mesh.panel);
    if (!range) return std::nullopt;
    const auto point = ray.origin + ray.direction * *range;
    const double along = (TPoint2D(point.x, point.y) - mesh.panel.line.point1).norm();
    const double up = point.z - mesh.panel.height.min();
    const bool onWire =
        std::fmod(along, mesh.pitch) < mesh.wire || std::fmod(up, mesh.pitch) < mesh.wire;
    return onWire ? range : std::nullopt;
}

std::optional<double> meet(const Ray& ray, const Plane& plane) {
    if (ray.direction.z == 0) return std::nullopt;
    const double range = (plane.z - ray.origin.z) / ray.direction.z;
    if (range <= 0) return std::nullopt;
    return range;
}

std::optional<double> meet(const Ray& ray, const Cylinder& cylinder) {
    // sheared upright, which leaves the distance along the ray as it is
    const TPoint2D direction =
        TPoint2D(ray.direction.x, ray.direction.y) - cylinder.lean * ray.direction.z;
    const TPoint2D fromAxis = TPoint2D(ray.origin.x, ray.origin.y) - cylinder.centre -
                              cylinder.lean * (ray.origin.z - cylinder.height.min());

    Stretch inside;
    inside.cutToSlab(ray.origin.z, ray.direction.z, cylinder.height.min(), cylinder.height.max());

    // |fromAxis + t direction|^2 = radius^2, solved for t
    const double a = dot(direction, direction);
    const double halfB = dot(direction, fromAxis);
    const double c = dot(fromAxis, fromAxis) - cylinder.radius * cylinder.radius;
    if (a == 0) {
        if (c > 0) return std::nullopt;
        return inside.entry();
    }
    const double discriminant = halfB * halfB - a * c;
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    inside.cutTo((-halfB - root) / a, (-halfB + root) / a);
    return inside.entry();
}

std::optional<double> meet(const Ray& ray, const Box& box) {
    const TPoint2D x(std::cos(box.centre.phi), std::sin(box.centre.phi)), y(-x.y, x.x);
    const TPoint2D direction(ray.direction.x, ray.direction.y);
    const TPoint2D fromCentre(ray.origin.x - box.centre.x, ray.origin.y - box.centre.y);

    Stretch inside;
    inside.cutToSlab(dot(fromCentre, x), dot(direction, x), -box.length / 2, box.length / 2);
    inside.cutToSlab(dot(fromCentre, y), dot(direction, y), -box.width / 2, box.width / 2);
    inside.cutToSlab(ray.origin.z, ray.direction.z, box.height.min(), box.height.max());
    return inside.entry();
}

}  // namespace offmap::evaluation
