// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/wrap2pi.h>

#include <numbers>

namespace offmap::rawlog {

/// [rad] In (-pi, pi]: mostly, an angle is already, and is left as it is.
inline double wrapped(double angle) {
    const bool isIn = -std::numbers::pi < angle && angle <= std::numbers::pi;
    return isIn ? angle : mrpt::math::wrapToPi(angle);
}

}  // namespace offmap::rawlog
