// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "WrappedAngle.h"

#include <offmap/rawlog/CloudPoints.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace offmap::rawlog {

/// [m^2] Nearer to the vertical axis than 1 cm, points have no azimuth worth the name.
constexpr float minSquaredGroundRange = 1e-4F;
/// [m^2] At 0.5 m, coordinates rounded to 1 mm leave an azimuth uncertain by 0.08 degrees.
constexpr float clearSquaredGroundRange = 0.25F;
/// Fewer on average are no columns.
constexpr uint32_t pointsPerArc = 4;

inline double azimuthOf(float x, float y) {
    return std::atan2(static_cast<double>(y), static_cast<double>(x));
}

/// False on the vertical axis.
inline bool hasAzimuth(float x, float y) { return x * x + y * y >= minSquaredGroundRange; }

/// True where the rounding of coordinates does not matter.
inline bool isClear(float x, float y) { return x * x + y * y >= clearSquaredGroundRange; }

/// What azimuths some points have, those on the vertical axis left out.
struct AzimuthArc {
    double begin = 0;     ///< [rad] the least, in (-pi, pi]
    double length = 0;    ///< [rad] to the greatest
    double sum = 0;       ///< [rad] of the azimuths, from begin on
    uint32_t points = 0;  ///< that they are of
    bool clear = false;   ///< one of them is so far from the axis that rounding does not matter
    uint32_t first = 0;   ///< where the points stand in the cloud
    uint32_t end = 0;     ///< likewise; some between may be on the vertical axis

    /// Near the axis, only points that agree tell of a column.
    bool isSure() const { return clear || points >= pointsPerArc; }
};

/// The arcs of points that stand one behind the other and look nearly the same way: where a cloud
/// is stored column by column, as many as there are columns. Those that do not look so are told
/// apart without their azimuths. In the order of the points; empty if they are in no such order.
std::vector<AzimuthArc> arcsInOrder(const CloudPoints& points);

/// Arcs of points in whatever order.
struct BinnedArcs {
    static constexpr uint32_t none = UINT32_MAX;
    std::vector<AzimuthArc> arcs;  ///< sorted; they say nothing of where points stand
    std::vector<uint32_t> arcOf;   ///< per point: index into arcs; none on the vertical axis
};

/// The arcs of bins that are far narrower than the columns of any scanner are apart.
BinnedArcs arcsInBins(const CloudPoints& points);

}  // namespace offmap::rawlog
