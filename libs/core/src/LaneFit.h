// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Lanes.h>
#include <offmap/core/LineFit.h>
#include <offmap/core/PlanePoints.h>

#include <cstdint>

namespace offmap::core {

/// LineSums, four points at a time.
class LaneSums {
 public:
    /// \param last so many of the four count, the last ones
    [[gnu::always_inline]] void add(const float* xs, const float* ys,
                                    uint32_t last = doubleLaneCount) {
        DoubleLanes x, y;
        load(xs, x);
        load(ys, y);
        if (last < doubleLaneCount) {
            keepLast(last, x);
            keepLast(last, y);
        }
        x_ += x;
        y_ += y;
        real_ += x * x - y * y;
        halfImag_ += x * y;
    }
    /// Lanes are added up as total() does it, those of all four sums together.
    LineSums of(uint32_t count) const {
        const DoubleLanes places = __builtin_shufflevector(x_, y_, 0, 4, 2, 6) +
                                   __builtin_shufflevector(x_, y_, 1, 5, 3, 7);
        const DoubleLanes squares = __builtin_shufflevector(real_, halfImag_, 0, 4, 2, 6) +
                                    __builtin_shufflevector(real_, halfImag_, 1, 5, 3, 7);
        return {count, __builtin_shufflevector(places, squares, 0, 1, 4, 5) +
                           __builtin_shufflevector(places, squares, 2, 3, 6, 7)};
    }

 private:
    DoubleLanes x_{}, y_{}, real_{}, halfImag_{};
};

/// Of all of the points, from (0, 0): within 1 km of it, sums lose less than floats do.
[[gnu::always_inline]] inline LineSums sumsOf(const PlanePoints& points) {
    const auto count = static_cast<uint32_t>(points.size());
    const float *x = points.x.data(), *y = points.y.data();
    if (count < doubleLaneCount) {
        LineSums sums;
        for (uint32_t i = 0; i < count; ++i) {
            sums.add(static_cast<double>(x[i]), static_cast<double>(y[i]));
        }
        return sums;
    }
    LaneSums sums;
    const uint32_t last = count - doubleLaneCount;
    uint32_t i = 0;
    for (; i <= last; i += doubleLaneCount) sums.add(x + i, y + i);
    sums.add(x + last, y + last, count - i);
    return sums.of(count);
}

}  // namespace offmap::core
