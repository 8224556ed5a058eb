// SPDX-License-Identifier: BSD-3-Clause
#include "LaneExtent.h"
#include "RootOfSquares.h"
#include "SegmentAtWall.h"

#include <offmap/core/ByProcessor.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace offmap::core {

namespace {

constexpr uint32_t leastReturns = 4;  // of a run: fewer are on one side of a wall by chance

/// -1 before the wall, 1 behind it, 0 where that cannot be told.
int sideOf(double behind, double sigmaRange) {
    const double undecided = 0.5 * sigmaRange;
    return behind > undecided ? 1 : behind < -undecided ? -1 : 0;
}

/// Neighbouring returns on the same side of the wall.
struct Run {
    uint32_t begin = 0;
    int side = 0;
    double sum = 0;        // [m] of their distances behind the wall
    double variances = 0;  // [m^2] of their ranges
};

/// [m] Of the range of one of them, in the quadratic mean.
double sigmaOf(const Run& run, uint32_t count, const ReturnOffsets& offsets) {
    return offsets.scan().rangeSigma.empty() ? offsets.config().sigmaRange
                                             : std::sqrt(run.variances / count);
}

/// \param common [m] standard deviation that all returns share; their own noise averages out
bool standsOff(const Run& run, uint32_t count, double common, const ReturnOffsets& offsets) {
    if (count < leastReturns) return false;
    const double sigmaRange = sigmaOf(run, count, offsets);
    const double own = sigmaRange / std::sqrt(count);
    // Being on one side is what makes a run: its mean is off by up to a sigma of noise.
    const double limit = offsets.config().gate * rootOfSquares(common, own) + sigmaRange;
    return std::abs(run.sum) / count > limit;
}

struct LineInFloats {
    explicit LineInFloats(const LinearDistance& behind)
        : ofSensor(static_cast<float>(behind.ofSensor)),
          perX(static_cast<float>(behind.perGround.x)),
          perY(static_cast<float>(behind.perGround.y)),
          perHeight(static_cast<float>(behind.perHeight)) {}
    float ofSensor;               // [m]
    float perX, perY, perHeight;  // [-]
};

/// [m] How far returns stand behind a straight line.
[[gnu::flatten]] OFFMAP_BY_PROCESSOR Extent extentBehind(const float* x, const float* y,
                                                         const float* z, uint32_t count,
                                                         const LineInFloats& line) {
    const auto [behind] = extentsOf<1>(count, [&](size_t i, auto& numbers) {
        std::remove_cvref_t<decltype(numbers[0])> east, north, up;
        load(x + i, east);
        load(y + i, north);
        load(z + i, up);
        numbers[0] = line.ofSensor + line.perX * east + line.perY * north + line.perHeight * up;
    });
    return behind;
}

/// Whether no run of a segment can stand off the wall, because not one of its returns does. Tells
/// so of most, at the cost of a glance.
bool allNear(const SegmentAtWall& atWall, const VerticalSegment& segment, uint32_t wall,
             const ReturnOffsets& offsets) {
    if (!atWall.isStraight()) return false;
    const LevelledScan& levelled = offsets.levelled();
    const uint32_t begin = segment.begin;
    const Extent behind =
        extentBehind(levelled.x.data() + begin, levelled.y.data() + begin,
                     levelled.z.data() + begin, segment.end - begin, LineInFloats(atWall.linear()));
    const double furthest = std::max(-behind.least, behind.greatest);
    // What standsOff() asks for, at least.
    constexpr double rounding = 1e-4;  // [m] of floats within 100 m
    const double leastSigma = offsets.scan().rangeSigma.empty() ? offsets.config().sigmaRange : 0;
    return furthest + rounding < offsets.config().gate * offsets.wall(wall).sigma + leastSigma;
}

}  // namespace

void keepRunsOffTheWall(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                        std::span<const SegmentMatch> matches, std::span<PointLabel> labels) {
    forEachRemoved(segments, matches, [&](const VerticalSegment& segment, uint32_t wall) {
        const SegmentAtWall atWall(offsets, segment, wall);
        if (allNear(atWall, segment, wall, offsets)) return;
        const double common = offsets.commonSigma(segment, wall);
        Run run;
        const auto end = [&](uint32_t at) {
            if (!standsOff(run, at - run.begin, common, offsets)) return;
            std::fill(labels.begin() + run.begin, labels.begin() + at, PointLabel::Kept);
        };
        for (uint32_t i = segment.begin; i < segment.end; ++i) {
            const double behind = atWall.behind(offsets.seen(i));
            const double sigmaRange = offsets.sigmaRange(i);
            const int side = sideOf(behind, sigmaRange);
            if (i == segment.begin || side != run.side) {
                if (i != segment.begin) end(i);
                run = {i, side, 0, 0};
            }
            run.sum += behind;
            run.variances += sigmaRange * sigmaRange;
        }
        end(segment.end);
    });
}

}  // namespace offmap::core
