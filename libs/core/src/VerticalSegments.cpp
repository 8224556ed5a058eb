// SPDX-License-Identifier: BSD-3-Clause
#include "LaneExtent.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/core/Lanes.h>
#include <offmap/core/VerticalSegments.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

OFFMAP_BY_PROCESSOR TPoint2D centreOf(const float* x, const float* y, uint32_t count) {
    if (count < doubleLaneCount) {
        TPoint2D sum;
        for (uint32_t i = 0; i < count; ++i) sum += TPoint2D(x[i], y[i]);
        return sum * (1.0 / count);
    }
    const uint32_t last = count - doubleLaneCount;
    DoubleLanes sumsX{}, sumsY{}, more;
    uint32_t i = 0;
    for (; i <= last; i += doubleLaneCount) {
        load(x + i, more);
        sumsX += more;
        load(y + i, more);
        sumsY += more;
    }
    load(x + last, more);
    keepLast(count - i, more);
    sumsX += more;
    load(y + last, more);
    keepLast(count - i, more);
    sumsY += more;
    return TPoint2D(total(sumsX), total(sumsY)) * (1.0 / count);
}

/// [m] Of points along a line, from a point on it. \param x, y of the first one
[[gnu::flatten]] OFFMAP_BY_PROCESSOR Extent extentAlong(const float* x, const float* y,
                                                        uint32_t count, float lineX, float lineY,
                                                        float alongX, float alongY) {
    return extentOf(count, [&](uint32_t i, auto& along) {
        std::remove_cvref_t<decltype(along)> pointX, pointY;
        load(x + i, pointX);
        load(y + i, pointY);
        along = (pointX - lineX) * alongX + (pointY - lineY) * alongY;
    });
}

[[gnu::flatten]] OFFMAP_BY_PROCESSOR Extent extentAmong(const float* values, uint32_t count) {
    return extentOf(count, [&](uint32_t i, auto& numbers) { load(values + i, numbers); });
}

/// The ends of a piece, and where it stands.
void measure(const LinePiece& piece, const LevelledScan& levelled, VerticalSegment& segment) {
    const uint32_t begin = segment.begin, count = segment.end - begin;
    const auto [least, greatest] = extentAlong(
        levelled.range.data() + begin, levelled.z.data() + begin, count,
        static_cast<float>(piece.line.point.x), static_cast<float>(piece.line.point.y),
        static_cast<float>(piece.line.direction.x), static_cast<float>(piece.line.direction.y));
    segment.bottom = piece.line.at(static_cast<double>(least));
    segment.top = piece.line.at(static_cast<double>(greatest));
    if (segment.bottom.y > segment.top.y) std::swap(segment.bottom, segment.top);
    segment.centre = centreOf(levelled.x.data() + begin, levelled.y.data() + begin, count);
}

}  // namespace

VerticalSegmentFinder::VerticalSegmentFinder(const VerticalConfig& config)
    : config_(config), maxSlope_(std::tan(config.maxTilt)) {}

/// What noise beyond the tolerance asks for; nothing where the scan tells of none.
void VerticalSegmentFinder::findSlack(std::span<const float> rangeSigma) {
    constexpr double sigmas = 3;
    slack_.clear();
    for (const double sigma : rangeSigma) {
        slack_.push_back(
            static_cast<float>(std::max(sigmas * sigma - config_.maxPointToLine, 0.0)));
    }
}

void VerticalSegmentFinder::addColumn(const OrganizedScan& scan, const LevelledScan& levelled,
                                      uint32_t column, std::vector<VerticalSegment>& segments) {
    const uint32_t begin = scan.columns[column].begin, end = scan.columns[column].end;
    if (end - begin < config_.minPoints) return;
    const std::span<const float> sigma = scan.rangeSigma;
    findSlack(sigma.empty() ? sigma : sigma.subspan(begin, end - begin));
    const SplitAndMergeConfig splitting{config_.maxPointToLine, config_.maxGap, config_.minLength,
                                        config_.minPoints, slack_};
    for (const LinePiece& piece :
         splitAndMerge(levelled.profile(begin, end), splitting, scratch_)) {
        const double aside = std::abs(piece.line.direction.x);
        const double upwards = std::abs(piece.line.direction.y);
        if (!(aside <= upwards * maxSlope_)) continue;
        VerticalSegment segment{
            column, begin + piece.begin, begin + piece.end, {}, {}, aside / upwards, {}};
        measure(piece, levelled, segment);
        segments.push_back(segment);
    }
}

void VerticalSegmentFinder::find(const OrganizedScan& scan, const LevelledScan& levelled,
                                 std::vector<VerticalSegment>& segments) {
    segments.clear();
    for (uint32_t c = 0; c < scan.columns.size(); ++c) addColumn(scan, levelled, c, segments);
}

Interval groundInterval(const VerticalSegment& segment, const LevelledScan& levelled,
                        double maxMountingSlope) {
    const uint32_t begin = segment.begin, count = segment.end - begin;
    const auto [nearest, furthest] = extentAmong(levelled.range.data() + begin, count);
    const auto [lowest, highest] = extentAmong(levelled.z.data() + begin, count);
    const double height = std::max(-lowest, highest);  // of the end furthest from the sensor's
    const double margin = height * maxMountingSlope;   // eqs. 4, 5
    return {static_cast<double>(nearest) - margin,
            static_cast<double>(furthest) + margin};  // eq. 3
}

}  // namespace offmap::core
