// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace offmap::rawlog {

/// An angle by its cosine and sine, for what needs them of many points.
struct Direction {
    double cos = 1, sin = 0;

    /// \param angle [rad]
    static Direction of(double angle) { return {std::cos(angle), std::sin(angle)}; }
    Direction turned(const Direction& by) const {
        return {cos * by.cos - sin * by.sin, sin * by.cos + cos * by.sin};
    }
};

}  // namespace offmap::rawlog
