// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineFit.h>
#include <offmap/core/PlanePoints.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace offmap::core {

/// How far points stand off a line, less their slack. All is told times the length of a vector
/// along the line, which spares divisions and roots.
class OffsetsFromLine {
 public:
    struct Points {
        const float *x, *y, *slack;  ///< [m] no slack: null
        uint32_t count;
    };
    struct Line {
        float x, y;            ///< [m] of a point on it
        float alongX, alongY;  ///< a vector along it
        float length;          ///< of that; only used with slack
    };
    struct Furthest {
        float offset;    ///< times the length; less than 0 if all are within their slack
        uint32_t point;  ///< the first of several
    };

    /// \param slack [m] per point, or empty
    OffsetsFromLine(const PlanePoints& points, std::span<const float> slack, const ScaledLine& line)
        : points_{points.x.data(), points.y.data(), slack.empty() ? nullptr : slack.data(),
                  static_cast<uint32_t>(points.size())},
          line_{static_cast<float>(line.point.x), static_cast<float>(line.point.y),
                static_cast<float>(line.along.x), static_cast<float>(line.along.y),
                slack.empty() ? 0 : static_cast<float>(std::sqrt(line.squaredLength))},
          squaredLength_(line.squaredLength) {}

    /// \pre there are points
    Furthest furthest() const;
    /// \param limit [m]
    bool anyBeyond(double limit) const;

    /// \param offset of a point; \param limit [m]
    bool isBeyond(float offset, double limit) const {
        const double beyond = std::max(static_cast<double>(offset), 0.0);
        return beyond * beyond > limit * limit * squaredLength_;
    }

 private:
    Points points_;
    Line line_;
    double squaredLength_;
};

}  // namespace offmap::core
