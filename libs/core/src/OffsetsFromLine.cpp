// SPDX-License-Identifier: BSD-3-Clause
#include "OffsetsFromLine.h"

#include "ByProcessor.h"
#include "Lanes.h"

#include <algorithm>

namespace offmap::core {

using Points = OffsetsFromLine::Points;
using Line = OffsetsFromLine::Line;
using Furthest = OffsetsFromLine::Furthest;

namespace {

/// Of less points than lanes.
inline Furthest furthestOfFew(const Points& points, const Line& line) {
    Furthest furthest{-1, 0};
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
[[gnu::always_inline]] inline void offsetsAt(const Points& points, uint32_t i, const Line& line,
                                             Lanes& offsets) {
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
OFFMAP_BY_PROCESSOR float greatestOf(const Points& points, const Line& line) {
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

OFFMAP_BY_PROCESSOR Furthest furthestOf(const Points& points, const Line& line) {
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

}  // namespace

OffsetsFromLine::Furthest OffsetsFromLine::furthest() const { return furthestOf(points_, line_); }

bool OffsetsFromLine::anyBeyond(double limit) const {
    return isBeyond(greatestOf(points_, line_), limit);
}

}  // namespace offmap::core
