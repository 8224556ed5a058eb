// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentAtWall.h"

#include <cmath>

namespace offmap::core {

namespace {

/// [m] Two returns nearer in height than this are of one level: noise, and floors are not even.
constexpr double levelTolerance = 0.03;

/// [m] A floor's next return is at least so much nearer to the sensor, or further, than its last.
constexpr double leastStep = 0.1;

/// Sigmas of a single range that a return has to stand before its segment: an end of a wall may
/// well happen to be at the height of the floor.
constexpr double clearlyBefore = 0.25;

class FootOfTheWall {
 public:
    FootOfTheWall(const ReturnOffsets& offsets, const VerticalSegment& segment, uint32_t wall)
        : offsets_(offsets),
          segment_(segment),
          atWall_(offsets, segment, wall),
          segmentBehind_(atWall_.behind(middleOf(segment))) {}

    /// Keeps returns from one end inwards. \param next the return beside that end
    void keep(uint32_t next, uint32_t first, int inwards, std::span<PointLabel> labels) const {
        const SeenPoint beside = offsets_.seen(next);
        for (uint32_t i = first; i - segment_.begin < segment_.end - segment_.begin;
             i += static_cast<uint32_t>(inwards)) {
            const SeenPoint here = offsets_.seen(i);
            const bool level =
                std::abs(atWall_.height(here) - atWall_.height(beside)) < levelTolerance;
            const bool apart = std::abs(here.ground.norm() - beside.ground.norm()) > leastStep;
            const double before = segmentBehind_ - atWall_.behind(here);
            if (!level || !apart || before < clearlyBefore * offsets_.sigmaRange(i)) return;
            labels[i] = PointLabel::Kept;
        }
    }

 private:
    const ReturnOffsets& offsets_;
    const VerticalSegment& segment_;
    SegmentAtWall atWall_;
    double segmentBehind_;  // [m] its middle, behind the wall
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
