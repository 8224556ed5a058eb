// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <span>

namespace offmap::core {

/// Points of a plane, their coordinates apart, so that many can be worked on together. As exact as
/// the returns of a scan are.
struct PlanePoints {
    std::span<const float> x, y;  ///< [m] of equal size

    size_t size() const { return x.size(); }
    mrpt::math::TPoint2D operator[](size_t i) const { return {x[i], y[i]}; }
    mrpt::math::TPoint2Df asFloats(size_t i) const { return {x[i], y[i]}; }
    PlanePoints range(size_t begin, size_t end) const {
        return {{x.data() + begin, end - begin}, {y.data() + begin, end - begin}};
    }
};

}  // namespace offmap::core
