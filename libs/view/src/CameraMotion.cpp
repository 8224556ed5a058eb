// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/CameraMotion.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offmap::view {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;

/// Unit vectors of the picture in the map's frame.
struct PictureAxes {
    TPoint3D towardsEye, right, up;
};

PictureAxes axesOf(const Camera& camera) {
    const double ca = std::cos(camera.azimuth), sa = std::sin(camera.azimuth);
    const double ce = std::cos(camera.elevation), se = std::sin(camera.elevation);
    return {{ce * ca, ce * sa, se}, {-sa, ca, 0}, {-se * ca, -se * sa, ce}};
}

/// [px] from the middle of the picture, right and up.
TPoint2D fromMiddle(const TPoint2D& place, const PictureSize& size) {
    return {place.x - 0.5 * size.width, 0.5 * size.height - place.y};
}

bool isParallel(const Camera& camera) { return camera.shorterSide > 0; }

/// What the camera's distance is for a picture of parallel beams, and the other way round.
void scale(Camera& camera, double factor) {
    constexpr double nearest = 0.2, farthest = 5000;  // [m]
    double& extent = isParallel(camera) ? camera.shorterSide : camera.distance;
    extent = std::clamp(factor * extent, nearest, farthest);
}

}  // namespace

double metresPerPixel(const Camera& camera, const PictureSize& size) {
    if (isParallel(camera)) return camera.shorterSide / std::min(size.width, size.height);
    return 2 * camera.distance * std::tan(0.5 * Camera::fieldOfView) / size.height;
}

Camera orbited(const Camera& camera, const TPoint2D& moved) {
    constexpr double perPixel = 0.006;  // [rad] half a turn for the width of a usual canvas
    Camera out = camera;
    out.azimuth = std::remainder(camera.azimuth - perPixel * moved.x, 2 * std::numbers::pi);
    const double elevation = camera.elevation + perPixel * moved.y;
    out.elevation = std::clamp(elevation, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
    return out;
}

Camera panned(const Camera& camera, const TPoint2D& moved, const PictureSize& size) {
    const PictureAxes axes = axesOf(camera);
    const double step = metresPerPixel(camera, size);
    Camera out = camera;
    out.target = camera.target - axes.right * (step * moved.x) + axes.up * (step * moved.y);
    return out;
}

Camera zoomed(const Camera& camera, double factor, const TPoint2D& place, const PictureSize& size) {
    const PictureAxes axes = axesOf(camera);
    Camera out = camera;
    scale(out, factor);
    const double step = metresPerPixel(camera, size) - metresPerPixel(out, size);
    const TPoint2D off = fromMiddle(place, size);
    out.target = camera.target + axes.right * (step * off.x) + axes.up * (step * off.y);
    return out;
}

SightLine sightLine(const Camera& camera, const TPoint2D& place, const PictureSize& size) {
    const PictureAxes axes = axesOf(camera);
    const TPoint2D off = fromMiddle(place, size);
    const double step = metresPerPixel(camera, size);
    const TPoint3D seen = camera.target + axes.right * (step * off.x) + axes.up * (step * off.y);
    if (isParallel(camera)) {
        constexpr double behind = 10'000;  // [m] nothing is further away
        return {seen + axes.towardsEye * behind, axes.towardsEye * -1.0};
    }
    const TPoint3D eye = camera.target + axes.towardsEye * camera.distance;
    const TPoint3D direction = seen - eye;
    return {eye, direction * (1 / direction.norm())};
}

}  // namespace offmap::view
