// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Lanes.h>

#include <algorithm>
#include <cstdint>

namespace offmap::core {

/// The least and the greatest of some values.
struct Extent {
    float least, greatest;
};

/// Of something that `at` tells of each point: at(i, number) of point i, at(i, lanes) of as many
/// points from there on. The last block ends with the points, so it may overlap the one before.
/// \pre count > 0
template <class At>
[[gnu::always_inline]] inline Extent extentOf(uint32_t count, const At& at) {
    if (count < laneCount) {
        float number;
        at(0, number);
        Extent extent{number, number};
        for (uint32_t i = 1; i < count; ++i) {
            at(i, number);
            extent = {std::min(extent.least, number), std::max(extent.greatest, number)};
        }
        return extent;
    }
    const uint32_t last = count - laneCount;
    Lanes least, greatest, lanes;
    at(last, least);
    greatest = least;
    for (uint32_t i = 0; i < last; i += laneCount) {
        at(i, lanes);
        least = lanes < least ? lanes : least;
        greatest = lanes > greatest ? lanes : greatest;
    }
    least = -least;
    spreadGreatest(least);
    spreadGreatest(greatest);
    return {-least[0], greatest[0]};
}

}  // namespace offmap::core
