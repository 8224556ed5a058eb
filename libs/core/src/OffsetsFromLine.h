// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Lanes.h>
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

/// Of less points than lanes.
inline OffsetsFromLine::Furthest furthestOfFew(const OffsetsFromLine::Points& points,
                                               const OffsetsFromLine::Line& line) {
    OffsetsFromLine::Furthest furthest{-1, 0};
    for (uint32_t i = 0; i < points.count; ++i) {
        const float off =
            (points.y[i] - line.y) * line.alongX - (points.x[i] - line.x) * line.alongY;
        const float offset =
            (off < 0 ? -off : off) - (points.slack ? points.slack[i] * line.length : 0);
        if (offset > furthest.offset) furthest = {offset, i};
    }
    return furthest;
}

/// Offsets of the points from i on.
[[gnu::always_inline]] inline void offsetsAt(const OffsetsFromLine::Points& points, uint32_t i,
                                             const OffsetsFromLine::Line& line, Lanes& offsets) {
    Lanes x, y;
    load(points.x + i, x);
    load(points.y + i, y);
    const Lanes off = (y - line.y) * line.alongX - (x - line.x) * line.alongY;
    offsets = off > -off ? off : -off;
    if (!points.slack) return;
    Lanes slack;
    load(points.slack + i, slack);
    offsets -= slack * line.length;
}

/// Blocks follow each other; the last one ends with the points, so it may overlap the one before.
inline float greatestOf(const OffsetsFromLine::Points& points, const OffsetsFromLine::Line& line) {
    if (points.count < laneCount) return furthestOfFew(points, line).offset;
    const uint32_t last = points.count - laneCount;
    Lanes most, offsets;
    offsetsAt(points, last, line, most);
    for (uint32_t i = 0; i < last; i += laneCount) {
        offsetsAt(points, i, line, offsets);
        most = offsets > most ? offsets : most;
    }
    spreadGreatest(most);
    return most[0];
}

inline OffsetsFromLine::Furthest furthestOf(const OffsetsFromLine::Points& points,
                                            const OffsetsFromLine::Line& line) {
    if (points.count < laneCount) return furthestOfFew(points, line);
    const uint32_t last = points.count - laneCount;
    Lanes most, offsets;
    LaneNumbers numbers = {0, 1, 2, 3, 4, 5, 6, 7}, furthest = numbers;
    offsetsAt(points, 0, line, most);
    for (uint32_t i = 0; i < last;) {
        const uint32_t step = std::min(laneCount, last - i);
        i += step;
        numbers += static_cast<int32_t>(step);
        offsetsAt(points, i, line, offsets);
        furthest = offsets > most ? numbers : furthest;
        most = offsets > most ? offsets : most;
    }
    Lanes greatest = most;
    spreadGreatest(greatest);
    const LaneNumbers none = LaneNumbers{} + static_cast<int32_t>(points.count);
    LaneNumbers negative = most == greatest ? -furthest : -none;  // the first is the greatest
    spreadGreatest(negative);
    return {greatest[0], static_cast<uint32_t>(-negative[0])};
}

inline OffsetsFromLine::Furthest OffsetsFromLine::furthest() const {
    return furthestOf(points_, line_);
}

inline bool OffsetsFromLine::anyBeyond(double limit) const {
    return isBeyond(greatestOf(points_, line_), limit);
}

}  // namespace offmap::core
