// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace offmap::core {

/// std::hypot() takes care of numbers near the limits of what a double holds, and its time; metres
/// and radians do not come near them.
inline double rootOfSquares(double a, double b) { return std::sqrt(a * a + b * b); }

}  // namespace offmap::core
