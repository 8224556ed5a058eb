// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TBoundingBox.h>
#include <mrpt/math/TPoint3D.h>

namespace offmap::view {

/// Where a picture is taken from.
struct Camera {
    mrpt::math::TPoint3D target;  ///< [m] map frame, in the middle of the picture
    double azimuth = 0.0;         ///< [rad] of the camera as seen from the target, CCW from +x
    double elevation = 0.0;       ///< [rad] of the camera above the target's horizon
    double distance = 10.0;       ///< [m] from the target; unused with parallel beams
    double shorterSide = 0.0;     ///< [m] of the picture with parallel beams; 0: perspective

    /// [rad] top to bottom, of a perspective picture.
    static constexpr double fieldOfView = 0.6;

    /// From above with parallel beams, x to the right and y up; the whole extent fits.
    /// \param aspect width / height of the picture
    static Camera top(const mrpt::math::TBoundingBox& extent, double aspect);

    /// The whole extent from one side and above, as in figure 7.
    static Camera perspective(const mrpt::math::TBoundingBox& extent, double aspect, double azimuth,
                              double elevation);
};

}  // namespace offmap::view
