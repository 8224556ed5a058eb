// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PlanePoints.h>

#include <cstdint>

namespace offmap::core {

/// Whether the step from a point to the next is too wide. \param x, y of both
inline bool isGap(const float* x, const float* y, float squaredGap) {
    const float stepX = x[1] - x[0], stepY = y[1] - y[0];
    return stepX * stepX + stepY * stepY > squaredGap;
}

/// Whether the step behind a point is above maxGap [m].
inline bool isGapBehind(const PlanePoints& points, uint32_t before, double maxGap) {
    return isGap(points.x.data() + before, points.y.data() + before,
                 static_cast<float>(maxGap * maxGap));
}

/// Where the points that lead up to `end` with no step above maxGap [m] begin.
/// \pre 0 < end <= points.size()
uint32_t beginOfRunWithoutGap(const PlanePoints& points, uint32_t end, double maxGap);

}  // namespace offmap::core
