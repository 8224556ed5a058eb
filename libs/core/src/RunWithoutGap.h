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

/// [m^2] Of the steps from as many points as there are lanes, each to the next.
[[gnu::always_inline]] inline void squaredSteps(const float* x, const float* y, Lanes& squares) {
    Lanes x0, x1, y0, y1;
    load(x, x0);
    load(x + 1, x1);
    load(y, y0);
    load(y + 1, y1);
    squares = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
}

/// Whether any of the steps between neighbours is above maxGap [m]: of most columns, none is.
inline bool hasGap(const PlanePoints& points, double maxGap) {
    const float *x = points.x.data(), *y = points.y.data();
    const auto squaredGap = static_cast<float>(maxGap * maxGap);
    const auto size = static_cast<uint32_t>(points.size());
    if (size <= laneCount) {
        for (uint32_t i = 1; i < size; ++i) {
            if (isGap(x + i - 1, y + i - 1, squaredGap)) return true;
        }
        return false;
    }
    const uint32_t last = size - 1 - laneCount;  // the last block may overlap the one before
    Lanes widest, squares;
    squaredSteps(x + last, y + last, widest);
    for (uint32_t i = 0; i < last; i += laneCount) {
        squaredSteps(x + i, y + i, squares);
        widest = squares > widest ? squares : widest;
    }
    spreadGreatest(widest);
    return widest[0] > squaredGap;
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
