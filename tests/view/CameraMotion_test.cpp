// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/CameraMotion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace offmap::view {
namespace {

using mrpt::math::TPoint3D;

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-9;  // some hundred roundings of values below 100
const PictureSize picture{800, 600};

Camera aside() {
    Camera camera;
    camera.target = {2, 3, 1};
    camera.azimuth = -2.0;
    camera.elevation = 0.5;
    camera.distance = 12;
    return camera;
}

Camera above() {
    Camera camera;
    camera.target = {2, 3, 1};
    camera.azimuth = -0.5 * pi;
    camera.elevation = 0.5 * pi;
    camera.shorterSide = 6;
    return camera;
}

/// Where a point stands in the picture [px]: the opposite way of sightLine(), by hand.
mrpt::math::TPoint2D seenAt(const Camera& camera, const TPoint3D& point) {
    const double ca = std::cos(camera.azimuth), sa = std::sin(camera.azimuth);
    const double ce = std::cos(camera.elevation), se = std::sin(camera.elevation);
    const TPoint3D p = point - camera.target;
    const double right = -sa * p.x + ca * p.y;
    const double up = -se * ca * p.x - se * sa * p.y + ce * p.z;
    const double depth = ce * ca * p.x + ce * sa * p.y + se * p.z;
    double perPixel = camera.shorterSide / 600;
    if (camera.shorterSide == 0) {
        perPixel = (camera.distance - depth) * std::tan(0.5 * Camera::fieldOfView) / 300;
    }
    return {400 + right / perPixel, 300 - up / perPixel};
}

TPoint3D alongBy(const SightLine& line, double distance) {
    return line.origin + line.direction * distance;
}

double distanceFrom(const SightLine& line, const TPoint3D& point) {
    const TPoint3D off = point - line.origin;
    const double along =
        off.x * line.direction.x + off.y * line.direction.y + off.z * line.direction.z;
    return (point - alongBy(line, along)).norm();
}

TEST(CameraMotion, middleOfThePictureLooksAtTheTarget) {
    for (const Camera& camera : {aside(), above()}) {
        EXPECT_NEAR(distanceFrom(sightLine(camera, {400, 300}, picture), camera.target), 0,
                    rounding);
    }
}

TEST(CameraMotion, sightLineMeetsWhatIsSeenThere) {
    const TPoint3D point{1.5, 4.2, 0.3};
    for (const Camera& camera : {aside(), above()}) {
        const SightLine line = sightLine(camera, seenAt(camera, point), picture);
        EXPECT_NEAR(distanceFrom(line, point), 0, rounding);
        EXPECT_NEAR(line.direction.norm(), 1, rounding);
    }
}

TEST(CameraMotion, zoomLeavesThePlaceUnderThePointer) {
    for (const Camera& camera : {aside(), above()}) {
        const mrpt::math::TPoint2D pointer{650, 120};
        const SightLine before = sightLine(camera, pointer, picture);
        // Where that line meets the plane of the target, in which panning and zooming work.
        TPoint3D met = camera.target;
        const Camera nearer = zoomed(camera, 0.5, pointer, picture);
        const TPoint3D towardsEye = sightLine(camera, {400, 300}, picture).direction * -1.0;
        const TPoint3D off = camera.target - before.origin;
        const double depth = off.x * towardsEye.x + off.y * towardsEye.y + off.z * towardsEye.z;
        const double step = before.direction.x * towardsEye.x + before.direction.y * towardsEye.y +
                            before.direction.z * towardsEye.z;
        met = alongBy(before, depth / step);
        EXPECT_NEAR(distanceFrom(sightLine(nearer, pointer, picture), met), 0, rounding);
        EXPECT_LT(metresPerPixel(nearer, picture), metresPerPixel(camera, picture));
    }
}

TEST(CameraMotion, panMovesThePictureWithTheHand) {
    for (const Camera& camera : {aside(), above()}) {
        const Camera moved = panned(camera, {37, -21}, picture);
        const auto seen = seenAt(moved, camera.target);
        EXPECT_NEAR(seen.x, 400 + 37, 1e-6);
        EXPECT_NEAR(seen.y, 300 - 21, 1e-6);
    }
}

TEST(CameraMotion, orbitKeepsTargetAndDistanceAndStopsAtTheZenith) {
    const Camera camera = aside();
    const Camera turned = orbited(camera, {100, 50});
    EXPECT_EQ(turned.target, camera.target);
    EXPECT_EQ(turned.distance, camera.distance);
    EXPECT_LT(turned.azimuth, camera.azimuth);
    EXPECT_GT(turned.elevation, camera.elevation);
    EXPECT_DOUBLE_EQ(orbited(camera, {0, 1e6}).elevation, 0.5 * pi);
    EXPECT_LE(std::abs(orbited(camera, {1e6, 0}).azimuth), pi);
}

TEST(CameraMotion, zoomEndsAtItsLimits) {
    Camera camera = aside();
    for (int i = 0; i < 200; ++i) camera = zoomed(camera, 0.5, {400, 300}, picture);
    EXPECT_DOUBLE_EQ(camera.distance, 0.2);
    for (int i = 0; i < 200; ++i) camera = zoomed(camera, 2, {400, 300}, picture);
    EXPECT_DOUBLE_EQ(camera.distance, 5000);
}

}  // namespace
}  // namespace offmap::view
