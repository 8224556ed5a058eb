// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Camera.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offmap::view {
namespace {

constexpr double margin = 1.05;  // of the picture about the extent

mrpt::math::TPoint3D centreOf(const mrpt::math::TBoundingBox& extent) {
    return (extent.min + extent.max) * 0.5;
}

}  // namespace

Camera Camera::top(const mrpt::math::TBoundingBox& extent, double aspect) {
    const auto size = extent.max - extent.min;
    Camera camera;
    camera.target = centreOf(extent);
    camera.azimuth = -0.5 * std::numbers::pi;
    camera.elevation = 0.5 * std::numbers::pi;
    camera.shorterSide = margin * (aspect >= 1 ? std::max(size.y, size.x / aspect)
                                               : std::max(size.x, size.y * aspect));
    return camera;
}

Camera Camera::perspective(const mrpt::math::TBoundingBox& extent, double aspect, double azimuth,
                           double elevation) {
    Camera camera;
    camera.target = centreOf(extent);
    camera.azimuth = azimuth;
    camera.elevation = elevation;
    const double ca = std::cos(azimuth), sa = std::sin(azimuth);
    const double ce = std::cos(elevation), se = std::sin(elevation);
    const double tanUp = std::tan(0.5 * fieldOfView), tanRight = tanUp * aspect;
    // A corner is in the picture if it is so far from the eye that it lies within both tangents.
    camera.distance = 0;
    for (const double x : {extent.min.x, extent.max.x})
        for (const double y : {extent.min.y, extent.max.y})
            for (const double z : {extent.min.z, extent.max.z}) {
                const auto p = mrpt::math::TPoint3D{x, y, z} - camera.target;
                const double towardsEye = ce * (ca * p.x + sa * p.y) + se * p.z;
                const double right = std::abs(ca * p.y - sa * p.x);
                const double up = std::abs(ce * p.z - se * (ca * p.x + sa * p.y));
                camera.distance = std::max(
                    camera.distance, towardsEye + margin * std::max(right / tanRight, up / tanUp));
            }
    return camera;
}

}  // namespace offmap::view
