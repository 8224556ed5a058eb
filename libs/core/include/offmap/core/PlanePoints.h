// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <span>

namespace offmap::core {

/// Points of a plane, coordinate by coordinate, as vector instructions want them.
struct PlanePoints {
    std::span<const double> x, y;  ///< [m] of equal size

    size_t size() const { return x.size(); }
    mrpt::math::TPoint2D operator[](size_t i) const { return {x[i], y[i]}; }
    PlanePoints range(size_t begin, size_t end) const {
        return {x.subspan(begin, end - begin), y.subspan(begin, end - begin)};
    }
};

}  // namespace offmap::core
