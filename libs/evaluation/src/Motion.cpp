// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Motion.h>

#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace offmap::evaluation {

mrpt::math::TPose2D moved(const mrpt::math::TPose2D& start, const Motion& motion, double seconds) {
    const double turned = motion.yawRate * seconds, way = motion.speed * seconds;
    // The chord of an arc stands half-way between the headings at its ends.
    const double half = 0.5 * turned;
    const double chord = half == 0 ? way : way * std::sin(half) / half;
    const double along = start.phi + half;
    return {start.x + chord * std::cos(along), start.y + chord * std::sin(along),
            mrpt::math::wrapToPi(start.phi + turned)};
}

}  // namespace offmap::evaluation
