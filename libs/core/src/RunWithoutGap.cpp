// SPDX-License-Identifier: BSD-3-Clause
#include "RunWithoutGap.h"

#include "ByProcessor.h"
#include "Lanes.h"

namespace offmap::core {

namespace {

/// Whether any of the steps from a point and those behind it is too wide.
[[gnu::always_inline]] inline bool anyGap(const float* x, const float* y, float squaredGap) {
    Lanes x0, x1, y0, y1;
    load(x, x0);
    load(x + 1, x1);
    load(y, y0);
    load(y + 1, y1);
    const Lanes squares = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
    const LaneNumbers gaps = squares > squaredGap;
    int32_t any = 0;
    for (uint32_t lane = 0; lane < laneCount; ++lane) any |= gaps[lane];
    return any != 0;
}

OFFMAP_BY_PROCESSOR uint32_t beginOfRun(const float* x, const float* y, uint32_t end,
                                        float squaredGap) {
    uint32_t i = end - 1;
    while (i >= laneCount && !anyGap(x + i - laneCount, y + i - laneCount, squaredGap)) {
        i -= laneCount;
    }
    while (i > 0 && !isGap(x + i - 1, y + i - 1, squaredGap)) --i;
    return i;
}

}  // namespace

uint32_t beginOfRunWithoutGap(const PlanePoints& points, uint32_t end, double maxGap) {
    return beginOfRun(points.x.data(), points.y.data(), end, static_cast<float>(maxGap * maxGap));
}

}  // namespace offmap::core
