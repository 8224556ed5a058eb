// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineFit.h>

namespace offmap::core {

LineFit fitOf(std::span<const mrpt::math::TPoint2D> points) {
    LineFit fit;
    for (const mrpt::math::TPoint2D& p : points) fit.add(p);
    return fit;
}

}  // namespace offmap::core
