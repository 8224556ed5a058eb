// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/PointLevel.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

namespace {

constexpr uint32_t leastReturns = 4;  // of a run: fewer are on one side of a wall by chance

/// -1 before the wall, 1 behind it, 0 where that cannot be told.
int sideOf(const WallOffset& offset, const AlignmentConfig& config) {
    const double undecided = 0.5 * config.sigmaRange;
    return offset.behind > undecided ? 1 : offset.behind < -undecided ? -1 : 0;
}

/// Neighbouring returns on the same side of the wall.
struct Run {
    uint32_t begin = 0;
    int side = 0;
    double sum = 0;    // [m] of their distances behind the wall
    double sigma = 0;  // [m] of the first one's
};

bool standsOff(const Run& run, uint32_t count, const AlignmentConfig& config) {
    if (count < leastReturns) return false;
    // What all returns have in common: pose and map. Their own noise averages out.
    const double common =
        std::sqrt(std::max(run.sigma * run.sigma - config.sigmaRange * config.sigmaRange, 0.0));
    const double own = config.sigmaRange / std::sqrt(count);
    // Being on one side is what makes a run: its mean is off by up to a sigma of noise.
    const double limit = config.gate * std::hypot(common, own) + config.sigmaRange;
    return std::abs(run.sum) / count > limit;
}

}  // namespace

void keepRunsOffTheWall(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                        std::span<const SegmentMatch> matches, std::span<PointLabel> labels) {
    for (size_t s = 0; s < segments.size(); ++s) {
        if (!matches[s].mapped() || !matches[s].wall) continue;
        const VerticalSegment& segment = segments[s];
        const ColumnPlace place = placeOf(offsets.scan().columns[segment.column]);
        Run run;
        const auto end = [&](uint32_t at) {
            if (!standsOff(run, at - run.begin, offsets.config())) return;
            std::fill(labels.begin() + run.begin, labels.begin() + at, PointLabel::Kept);
        };
        for (uint32_t i = segment.begin; i < segment.end; ++i) {
            const WallOffset offset = offsets.of(i, place, *matches[s].wall);
            const int side = sideOf(offset, offsets.config());
            if (i == segment.begin || side != run.side) {
                if (i != segment.begin) end(i);
                run = {i, side, 0, offset.sigma};
            }
            run.sum += offset.behind;
        }
        end(segment.end);
    }
}

}  // namespace offmap::core
