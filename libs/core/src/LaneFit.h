// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Lanes.h>
#include <offmap/core/LineFit.h>
#include <offmap/core/PlanePoints.h>

#include <cstdint>

namespace offmap::core {

/// Sums over points as LineFit takes them, four points at a time.
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
    LineFit fit(uint32_t count) const {
        return {count, {0, 0}, {total(x_), total(y_), total(real_), total(halfImag_)}};
    }

 private:
    DoubleLanes x_{}, y_{}, real_{}, halfImag_{};
};

/// Through all of the points, which stand near (0, 0): within 1 km of it, sums lose less than
/// floats do.
[[gnu::always_inline]] inline LineFit fitOf(const PlanePoints& points) {
    const auto count = static_cast<uint32_t>(points.size());
    const float *x = points.x.data(), *y = points.y.data();
    if (count < doubleLaneCount) {
        LineFit::Sums sums;
        for (uint32_t i = 0; i < count; ++i) {
            sums.add(static_cast<double>(x[i]), static_cast<double>(y[i]));
        }
        return {count, {0, 0}, sums};
    }
    LaneSums sums;
    const uint32_t last = count - doubleLaneCount;
    uint32_t i = 0;
    for (; i <= last; i += doubleLaneCount) sums.add(x + i, y + i);
    sums.add(x + last, y + last, count - i);
    return sums.fit(count);
}

}  // namespace offmap::core
