// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentAtWall.h"

#include <cmath>

namespace offmap::core {

namespace {

/// [m] Two returns nearer in height than this are of one level: noise, and floors are not even.
constexpr double levelTolerance = 0.03;

/// [m] A floor's next return is at least so much nearer to the sensor, or further, than its last.
constexpr double leastStep = 0.06;

/// Sigmas of a single range that a return has to stand before its segment: an end of a wall may
/// well happen to be at the height of the floor.
constexpr double clearlyBefore = 0.25;

class FootOfTheWall {
 public:
    FootOfTheWall(const ReturnOffsets& offsets, const VerticalSegment& segment, uint32_t wall)
        : offsets_(offsets),
          segment_(segment),
          wall_(wall),
          column_(offsets.corrected(segment.column)) {}

    /// Keeps returns from one end inwards. \param next the return beside that end
    void keep(uint32_t next, uint32_t first, int inwards, std::span<PointLabel> labels) const {
        if (!mayBeOneSurface(first, next)) return;  // so it is mostly
        const SegmentAtWall atWall(offsets_, segment_, wall_);
        const double segmentBehind = atWall.behind(middleOf(segment_));
        for (uint32_t i = first; i - segment_.begin < segment_.end - segment_.begin;
             i += static_cast<uint32_t>(inwards)) {
            const double before = segmentBehind - atWall.behind(offsets_.seen(i));
            if (!mayBeOneSurface(i, next) || before < clearlyBefore * offsets_.sigmaRange(i))
                return;
            labels[i] = PointLabel::Kept;
        }
    }

 private:
    /// Whether two returns are of one level and yet apart.
    bool mayBeOneSurface(uint32_t i, uint32_t next) const {
        const double step = offsets_.groundRange(i) - offsets_.groundRange(next);
        if (!(std::abs(step) > leastStep)) return false;
        const double rise = column_.height(offsets_.seen(i)) - column_.height(offsets_.seen(next));
        return std::abs(rise) < levelTolerance;
    }

    const ReturnOffsets& offsets_;
    const VerticalSegment& segment_;
    uint32_t wall_;
    CorrectedColumn column_;
};

}  // namespace

void keepFloorAtTheFoot(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                        std::span<const SegmentMatch> matches, std::span<PointLabel> labels) {
    forEachRemoved(segments, matches, [&](const VerticalSegment& segment, uint32_t wall) {
        const ScanColumn& column = offsets.scan().columns[segment.column];
        const FootOfTheWall foot(offsets, segment, wall);
        if (segment.begin > column.begin) foot.keep(segment.begin - 1, segment.begin, 1, labels);
        if (segment.end < column.end) foot.keep(segment.end, segment.end - 1, -1, labels);
    });
}

}  // namespace offmap::core
