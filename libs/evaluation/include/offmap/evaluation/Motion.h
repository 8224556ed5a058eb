// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPose2D.h>

namespace offmap::evaluation {

/// How a robot moves on the ground, evenly.
struct Motion {
    double speed = 0;    ///< [m/s] along its heading
    double yawRate = 0;  ///< [rad/s] CCW

    bool isNone() const { return speed == 0 && yawRate == 0; }
};

/// Where it is so many seconds later: on an arc, or a straight line.
mrpt::math::TPose2D moved(const mrpt::math::TPose2D& start, const Motion& motion, double seconds);

}  // namespace offmap::evaluation
