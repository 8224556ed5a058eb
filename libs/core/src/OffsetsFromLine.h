// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LaneExtent.h"

#include <offmap/core/Lanes.h>
#include <offmap/core/LineFit.h>
#include <offmap/core/PlanePoints.h>

#include <cmath>
#include <cstdint>
#include <limits>
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
        float alongX, alongY;  ///< a vector along it
        float offset;          ///< [m] of (0, 0), times `length`
        float length;          ///< of that vector
    };

    /// \param slack [m] per point, or empty
    OffsetsFromLine(const PlanePoints& points, std::span<const float> slack, const ScaledLine& line)
        : points_{points.x.data(), points.y.data(), slack.empty() ? nullptr : slack.data(),
                  static_cast<uint32_t>(points.size())},
          line_{static_cast<float>(line.along.x), static_cast<float>(line.along.y),
                static_cast<float>(line.point.y * line.along.x - line.point.x * line.along.y),
                static_cast<float>(std::sqrt(line.squaredLength))} {}

    /// \param limit [m]
    bool anyBeyond(double limit) const {
        const auto [offsets] =
            extentsOf<1>(points_.count, [&](size_t i, auto& numbers) { of(i, numbers[0]); });
        return isBeyond(offsets.greatest, limit);
    }

    /// Whether the offset of a point, or any of some, is above a limit [m].
    template <class Numbers>
    [[gnu::always_inline]] bool isBeyond(const Numbers& offsets, double limit) const {
        return any(offsets > static_cast<float>(limit) * line_.length);
    }

    /// Of one point, or of as many from there on as there are lanes.
    template <class Numbers>
    [[gnu::always_inline]] void of(size_t first, Numbers& offsets) const {
        Numbers x, y;
        load(points_.x + first, x);
        load(points_.y + first, y);
        const Numbers off = (y * line_.alongX - x * line_.alongY) - line_.offset;
        magnitudes(off, offsets);
        if (!points_.slack) return;
        Numbers slack;
        load(points_.slack + first, slack);
        offsets -= slack * line_.length;
    }
    float of(uint32_t point) const {
        float offset;
        of(point, offset);
        return offset;
    }
    uint32_t count() const { return points_.count; }

 private:
    Points points_;
    Line line_;
};

/// Which point is furthest off. Each lane has one of its own until that is asked for.
class FurthestFromLine {
 public:
    /// \pre there are points
    [[gnu::always_inline]] explicit FurthestFromLine(const OffsetsFromLine& of) : of_(of) {
        if (of.count() < laneCount) {
            findAmongFew();
        } else {
            findInLanes();
        }
    }
    bool isBeyond(double limit) const { return of_.isBeyond(offsets_, limit); }
    /// The first of several.
    uint32_t point() const {
        Lanes greatest = offsets_;
        spreadGreatest(greatest);
        constexpr LaneNumbers none = LaneNumbers{} + std::numeric_limits<int32_t>::min();
        LaneNumbers negative = offsets_ == greatest ? -points_ : none;
        spreadGreatest(negative);
        return static_cast<uint32_t>(-negative[0]);
    }

 private:
    [[gnu::always_inline]] void findAmongFew() {
        float most = of_.of(0);
        int32_t furthest = 0;
        for (uint32_t i = 1; i < of_.count(); ++i) {
            const float offset = of_.of(i);
            if (offset > most) most = offset, furthest = static_cast<int32_t>(i);
        }
        offsets_ = Lanes{} + most;
        points_ = LaneNumbers{} + furthest;
    }
    [[gnu::always_inline]] void findInLanes() {
        constexpr LaneNumbers fromZero = {0, 1, 2, 3, 4, 5, 6, 7};
        const uint32_t last = of_.count() - laneCount;
        of_.of(last, offsets_);
        points_ = fromZero + static_cast<int32_t>(last);
        uint32_t i = (last + laneCount - 1) / laneCount * laneCount;
        LaneNumbers more = fromZero + static_cast<int32_t>(i);
        Lanes offsets;
        while (i > 0) {  // backwards, as the first of several counts
            i -= laneCount;
            more -= static_cast<int32_t>(laneCount);
            of_.of(i, offsets);
            points_ = offsets >= offsets_ ? more : points_;
            offsets_ = offsets_ > offsets ? offsets_ : offsets;
        }
    }

    OffsetsFromLine of_;
    Lanes offsets_;
    LaneNumbers points_;
};

}  // namespace offmap::core
