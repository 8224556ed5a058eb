// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Camera.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>

namespace offmap::view {

/// How a camera is moved by hand. A picture has its origin at its upper left corner. All functions
/// are pure; distances stay within 0.2 m and 5 km.
struct PictureSize {
    uint32_t width = 1, height = 1;  ///< [px]
};

/// Turns the camera about its target. \param moved [px] of the hand, right and down
Camera orbited(const Camera& camera, const mrpt::math::TPoint2D& moved);

/// Shifts the target in the plane of the picture, so that it follows the hand.
Camera panned(const Camera& camera, const mrpt::math::TPoint2D& moved, const PictureSize& size);

/// Comes nearer to what is below a place of the picture, which stays there.
/// \param factor of the distance; < 1: nearer \param place [px]
Camera zoomed(const Camera& camera, double factor, const mrpt::math::TPoint2D& place,
              const PictureSize& size);

/// A line from the eye (or, with parallel beams, from behind it) through a place of the picture.
struct SightLine {
    mrpt::math::TPoint3D origin, direction;  ///< [m] map frame; unit vector
};
SightLine sightLine(const Camera& camera, const mrpt::math::TPoint2D& place,
                    const PictureSize& size);

/// [m] that a pixel covers at the target's distance.
double metresPerPixel(const Camera& camera, const PictureSize& size);

}  // namespace offmap::view
