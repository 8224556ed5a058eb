// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Picking.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace offmap::view {

using mrpt::math::TPoint3D;

std::optional<size_t> pick(const PlacedReturns& returns, const ViewRay& ray,
                           std::span<const uint8_t> hidden) {
    if (!hidden.empty() && hidden.size() != returns.points.size()) {
        throw std::invalid_argument("pick: one entry per return is needed of what is hidden");
    }
    const double length = ray.direction.norm();
    if (!(length > 0 && std::isfinite(length))) {
        throw std::invalid_argument("pick: the ray has no direction");
    }
    const TPoint3D along = ray.direction * (1 / length);
    const double widening = std::tan(ray.angle);
    std::optional<size_t> nearest;
    double least = std::numeric_limits<double>::max();
    for (size_t i = 0; i < returns.points.size(); ++i) {
        const TPoint3D p = TPoint3D(returns.points[i]) - ray.origin;
        const double depth = p.x * along.x + p.y * along.y + p.z * along.z;
        if (!(depth > 0 && depth < least)) continue;
        const double rim = ray.radius + depth * widening;
        const TPoint3D aside = p - along * depth;
        const double square = aside.x * aside.x + aside.y * aside.y + aside.z * aside.z;
        if (!(square <= rim * rim)) continue;
        if (!hidden.empty() && hidden[i] != 0) continue;
        nearest = i;
        least = depth;
    }
    return nearest;
}

}  // namespace offmap::view
