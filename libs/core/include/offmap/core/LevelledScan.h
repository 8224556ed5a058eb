// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPoint3D.h>

#include <vector>

namespace offmap::core {

/// A scan's points turned upright: from the sensor, along the axes of the map. Roll and pitch of
/// the vehicle and of the mounting are so undone before anything is called vertical. In a column
/// without a pose, the axes are those of the vehicle.
struct LevelledScan {
    std::vector<mrpt::math::TPoint2D> ground;  ///< [m] x, y per point, from the sensor
    std::vector<mrpt::math::TPoint2D>
        profile;  ///< [m] (ground range, z) per point, from the sensor
};

void level(const OrganizedScan& scan, LevelledScan& levelled);

}  // namespace offmap::core
