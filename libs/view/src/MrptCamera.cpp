// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/MrptCamera.h>

#include <mrpt/core/bits_math.h>

namespace offmap::view {

mrpt::opengl::CCamera mrptCameraOf(const Camera& camera) {
    mrpt::opengl::CCamera c;
    c.setPointingAt(camera.target);
    c.setAzimuthDegrees(static_cast<float>(mrpt::RAD2DEG(camera.azimuth)));
    c.setElevationDegrees(static_cast<float>(mrpt::RAD2DEG(camera.elevation)));
    const bool parallel = camera.shorterSide > 0;
    c.setOrthogonal(parallel);
    c.setProjectiveFOVdeg(static_cast<float>(mrpt::RAD2DEG(Camera::fieldOfView)));
    // With parallel beams MRPT shows half the zoom distance on the picture's shorter side.
    c.setZoomDistance(static_cast<float>(parallel ? 2 * camera.shorterSide : camera.distance));
    return c;
}

}  // namespace offmap::view
