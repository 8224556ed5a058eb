// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LaneExtent.h"

#include <offmap/core/Lanes.h>
#include <offmap/core/PlanePoints.h>

#include <cstdint>

namespace offmap::core {

/// [m^2] Of the step from a point to the next, or from as many points as there are lanes.
template <class Numbers>
[[gnu::always_inline]] inline void squaredSteps(const float* x, const float* y, Numbers& squares) {
    Numbers x0, x1, y0, y1;
    load(x, x0);
    load(x + 1, x1);
    load(y, y0);
    load(y + 1, y1);
    squares = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
}

/// Whether the step from a point to the next is too wide. \param x, y of both
inline bool isGap(const float* x, const float* y, float squaredGap) {
    float square;
    squaredSteps(x, y, square);
    return square > squaredGap;
}

/// Whether the step behind a point is above maxGap [m].
inline bool isGapBehind(const PlanePoints& points, uint32_t before, double maxGap) {
    return isGap(points.x.data() + before, points.y.data() + before,
                 static_cast<float>(maxGap * maxGap));
}

/// Whether any of the steps between neighbours is above maxGap [m]: of most columns, none is.
inline bool hasGap(const PlanePoints& points, double maxGap) {
    const auto size = static_cast<uint32_t>(points.size());
    if (size < 2) return false;
    const auto [steps] = extentsOf<1>(size - 1, [&](size_t i, auto& squares) {
        squaredSteps(points.x.data() + i, points.y.data() + i, squares[0]);
    });
    return steps.greatest > static_cast<float>(maxGap * maxGap);
}

/// Where the points that lead up to `end` with no step above maxGap [m] begin.
/// \pre 0 < end <= points.size()
inline uint32_t beginOfRunWithoutGap(const PlanePoints& points, uint32_t end, double maxGap) {
    const float *x = points.x.data(), *y = points.y.data();
    const auto squaredGap = static_cast<float>(maxGap * maxGap);
    uint32_t i = end - 1;
    for (; i >= laneCount; i -= laneCount) {
        Lanes squares;
        squaredSteps(x + i - laneCount, y + i - laneCount, squares);
        if (any(squares > squaredGap)) break;
    }
    while (i > 0 && !isGap(x + i - 1, y + i - 1, squaredGap)) --i;
    return i;
}

}  // namespace offmap::core
