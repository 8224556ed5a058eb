// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PointLevel.h>
#include <offmap/core/WallGeometry.h>

namespace offmap::core {

inline SeenPoint middleOf(const VerticalSegment& segment) {
    return {segment.centre, 0.5 * (segment.bottom.y + segment.top.y)};
}

/// A removed segment and the wall that it was removed with.
class SegmentAtWall {
 public:
    SegmentAtWall(const ReturnOffsets& offsets, const VerticalSegment& segment, uint32_t wall)
        : wall_(offsets.wall(wall)),
          column_(offsets.corrected(segment.column)),
          normal_(offsets.map().normalAwayFrom(segment.centre, wall,
                                               column_.place(offsets.seen(segment.begin)))),
          linear_(column_.distanceBehind(wall_.line.point1, normal_)) {}

    bool isStraight() const { return wall_.curvature == 0; }

    /// [m] From the wall, negative in front of it.
    double behind(const SeenPoint& seen) const {
        if (isStraight()) return linear_.of(seen);
        return distanceBehind(column_.place(seen), wall_, normal_);
    }

    /// behind() of a straight wall.
    const LinearDistance& linear() const { return linear_; }

 private:
    const Wall& wall_;
    CorrectedColumn column_;
    mrpt::math::TPoint2D normal_;
    LinearDistance linear_;
};

/// Calls visit(segment, wall index) for each segment that was removed with a wall.
template <class Visit>
void forEachRemoved(std::span<const VerticalSegment> segments,
                    std::span<const SegmentMatch> matches, Visit&& visit) {
    for (size_t s = 0; s < segments.size(); ++s) {
        if (matches[s].mapped() && matches[s].wall) visit(segments[s], *matches[s].wall);
    }
}

}  // namespace offmap::core
