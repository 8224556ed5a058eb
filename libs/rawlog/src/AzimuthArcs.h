// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint3D.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// [m] Coordinates rounded to 1 mm leave an azimuth uncertain by 0.08 degrees here.
constexpr double minGroundRange = 0.5;

inline double azimuthOf(const mrpt::math::TPoint3Df& p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
}

/// False within minGroundRange of the vertical axis.
inline bool hasAzimuth(const mrpt::math::TPoint3Df& p) {
    const double x = p.x, y = p.y;
    return x * x + y * y >= minGroundRange * minGroundRange;
}

/// What azimuths some points have, those near the vertical axis left out.
struct AzimuthArc {
    double begin = 0;   ///< [rad] the least, in (-pi, pi]
    double length = 0;  ///< [rad] to the greatest
    double sum = 0;     ///< [rad] of the azimuths, from begin on
    size_t points = 0;  ///< that they are of
    size_t first = 0;   ///< where the points stand in the cloud
    size_t end = 0;     ///< likewise; some between may be near the vertical axis
};

/// The arcs of points that stand one behind the other and look nearly the same way: where a cloud
/// is stored column by column, as many as there are columns. Those that do not look so are told
/// apart without their azimuths. Empty if the points are in no such order.
std::vector<AzimuthArc> arcsInOrder(std::span<const mrpt::math::TPoint3Df> points);

/// An arc for each point, sorted.
std::vector<AzimuthArc> arcsOfPoints(std::span<const mrpt::math::TPoint3Df> points);

}  // namespace offmap::rawlog
