// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Lanes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace offmap::core {

/// The least and the greatest of some values.
struct Extent {
    float least, greatest;
};

/// Of some quantities that `at` tells of each point: at(i, numbers) of point i, at(i, lanes) of as
/// many points from there on; one number, or lanes, a quantity. The last block ends with the
/// points, so it may overlap the one before. \pre count > 0
template <size_t quantities, class At>
[[gnu::always_inline]] inline std::array<Extent, quantities> extentsOf(uint32_t count,
                                                                       const At& at) {
    std::array<Extent, quantities> extents;
    if (count < laneCount) {
        float numbers[quantities];
        at(0, numbers);
        for (size_t q = 0; q < quantities; ++q) extents[q] = {numbers[q], numbers[q]};
        for (size_t i = 1; i < count; ++i) {
            at(i, numbers);
            for (size_t q = 0; q < quantities; ++q) {
                extents[q] = {std::min(extents[q].least, numbers[q]),
                              std::max(extents[q].greatest, numbers[q])};
            }
        }
        return extents;
    }
    const size_t last = count - laneCount;
    Lanes least[quantities], greatest[quantities], lanes[quantities];
    at(last, least);
    for (size_t q = 0; q < quantities; ++q) greatest[q] = least[q];
    for (size_t i = 0; i < last; i += laneCount) {
        at(i, lanes);
        for (size_t q = 0; q < quantities; ++q) {
            least[q] = lanes[q] < least[q] ? lanes[q] : least[q];
            greatest[q] = lanes[q] > greatest[q] ? lanes[q] : greatest[q];
        }
    }
    for (size_t q = 0; q < quantities; ++q) {
        least[q] = -least[q];
        spreadGreatest(least[q]);
        spreadGreatest(greatest[q]);
        extents[q] = {-least[q][0], greatest[q][0]};
    }
    return extents;
}

}  // namespace offmap::core
