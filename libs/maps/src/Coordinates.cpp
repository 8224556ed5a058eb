// SPDX-License-Identifier: BSD-3-Clause
#include "Coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace offmap::maps {

void convert(OGRCoordinateTransformation& conversion, std::span<mrpt::math::TPoint2D> points) {
    constexpr size_t batch = 4096;  // GDAL wants x and y apart
    std::vector<double> x, y;
    for (size_t begin = 0; begin < points.size(); begin += batch) {
        const auto part = points.subspan(begin, std::min(batch, points.size() - begin));
        x.clear();
        y.clear();
        for (const auto& point : part) {
            x.push_back(point.x);
            y.push_back(point.y);
        }
        std::vector<int> done(part.size());
        conversion.Transform(static_cast<int>(part.size()), x.data(), y.data(), nullptr,
                             done.data());
        for (size_t i = 0; i < part.size(); ++i) {
            constexpr double none = std::numeric_limits<double>::infinity();
            part[i] =
                done[i] != 0 ? mrpt::math::TPoint2D(x[i], y[i]) : mrpt::math::TPoint2D(none, none);
        }
    }
}

Extent extentOf(std::span<const mrpt::math::TPoint2D> points) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    Extent extent{{endless, endless}, {-endless, -endless}};
    for (const auto& point : points) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
        extent.low = {std::min(extent.low.x, point.x), std::min(extent.low.y, point.y)};
        extent.high = {std::max(extent.high.x, point.x), std::max(extent.high.y, point.y)};
    }
    return extent;
}

}  // namespace offmap::maps
