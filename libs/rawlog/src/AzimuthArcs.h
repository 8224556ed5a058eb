// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/CloudPoints.h>

#include <mrpt/math/wrap2pi.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace offmap::rawlog {

/// [m] Coordinates rounded to 1 mm leave an azimuth uncertain by 0.08 degrees here.
constexpr double minGroundRange = 0.5;

/// In (-pi, pi]: mostly, an angle is already, and is left as it is.
inline double wrapped(double angle) {
    const bool isIn = -std::numbers::pi < angle && angle <= std::numbers::pi;
    return isIn ? angle : mrpt::math::wrapToPi(angle);
}

inline double azimuthOf(float x, float y) {
    return std::atan2(static_cast<double>(y), static_cast<double>(x));
}

/// False within minGroundRange of the vertical axis.
inline bool hasAzimuth(float x, float y) {
    const double xx = x, yy = y;
    return xx * xx + yy * yy >= minGroundRange * minGroundRange;
}

/// What azimuths some points have, those near the vertical axis left out.
struct AzimuthArc {
    double begin = 0;     ///< [rad] the least, in (-pi, pi]
    double length = 0;    ///< [rad] to the greatest
    double sum = 0;       ///< [rad] of the azimuths, from begin on
    uint32_t points = 0;  ///< that they are of
    uint32_t first = 0;   ///< where the points stand in the cloud
    uint32_t end = 0;     ///< likewise; some between may be near the vertical axis
};

/// The arcs of points that stand one behind the other and look nearly the same way: where a cloud
/// is stored column by column, as many as there are columns. Those that do not look so are told
/// apart without their azimuths. In the order of the points; empty if they are in no such order.
std::vector<AzimuthArc> arcsInOrder(const CloudPoints& points);

/// Arcs of points in whatever order.
struct BinnedArcs {
    static constexpr uint32_t none = UINT32_MAX;
    std::vector<AzimuthArc> arcs;  ///< sorted; they say nothing of where points stand
    std::vector<uint32_t> arcOf;   ///< per point: index into arcs; none near the vertical axis
};

/// The arcs of bins that are far narrower than the columns of any scanner are apart.
BinnedArcs arcsInBins(const CloudPoints& points);

}  // namespace offmap::rawlog
