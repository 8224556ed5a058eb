// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Lanes.h>
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

/// Whether any of the steps from a point and those behind it is too wide.
[[gnu::always_inline]] inline bool anyGap(const float* x, const float* y, float squaredGap) {
    Lanes x0, x1, y0, y1;
    load(x, x0);
    load(x + 1, x1);
    load(y, y0);
    load(y + 1, y1);
    const Lanes squares = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
    return any(squares > squaredGap);
}

/// Where the points that lead up to `end` with no step above maxGap [m] begin.
/// \pre 0 < end <= points.size()
inline uint32_t beginOfRunWithoutGap(const PlanePoints& points, uint32_t end, double maxGap) {
    const float *x = points.x.data(), *y = points.y.data();
    const auto squaredGap = static_cast<float>(maxGap * maxGap);
    uint32_t i = end - 1;
    while (i >= laneCount && !anyGap(x + i - laneCount, y + i - laneCount, squaredGap)) {
        i -= laneCount;
    }
    while (i > 0 && !isGap(x + i - 1, y + i - 1, squaredGap)) --i;
    return i;
}

}  // namespace offmap::core
