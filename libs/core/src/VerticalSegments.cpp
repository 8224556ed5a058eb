// SPDX-License-Identifier: BSD-3-Clause
#include "LaneExtent.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/core/Lanes.h>
#include <offmap/core/VerticalSegments.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

TPoint2D centreOf(const float* x, const float* y, uint32_t count) {
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

/// The ends of a piece, what it spans, and where it stands.
[[gnu::flatten]] OFFMAP_BY_PROCESSOR void measure(const LinePiece& piece,
                                                  const LevelledScan& levelled,
                                                  VerticalSegment& segment) {
    const uint32_t begin = segment.begin - levelled.first, count = segment.end - segment.begin;
    const auto [point, direction] = piece.line;
    const auto lineRange = static_cast<float>(point.x), lineZ = static_cast<float>(point.y);
    const auto perRange = static_cast<float>(direction.x), perZ = static_cast<float>(direction.y);
    const auto [range, z, along] = extentsOf<3>(count, [&](size_t i, auto& numbers) {
        load(levelled.range.data() + begin + i, numbers[0]);
        load(levelled.z.data() + begin + i, numbers[1]);
        numbers[2] = (numbers[0] - lineRange) * perRange + (numbers[1] - lineZ) * perZ;
    });
    segment.nearest = static_cast<double>(range.least);
    segment.furthest = static_cast<double>(range.greatest);
    segment.lowest = static_cast<double>(z.least);
    segment.highest = static_cast<double>(z.greatest);
    segment.bottom = piece.line.at(static_cast<double>(along.least));
    segment.top = piece.line.at(static_cast<double>(along.greatest));
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
                                        config_.minPoints,      slack_,         maxSlope_};
    for (const LinePiece& piece :
         splitAndMerge(levelled.profile(begin, end), splitting, scratch_)) {
        // In place: what is copied has to wait to be written.
        VerticalSegment& segment = segments.emplace_back();
        segment.column = column;
        segment.begin = begin + piece.begin;
        segment.end = begin + piece.end;
        segment.slope = std::abs(piece.line.direction.x / piece.line.direction.y);
        measure(piece, levelled, segment);
    }
}

void VerticalSegmentFinder::find(const OrganizedScan& scan, const LevelledScan& levelled,
                                 std::vector<VerticalSegment>& segments) {
    segments.clear();
    for (uint32_t c = 0; c < scan.columns.size(); ++c) addColumn(scan, levelled, c, segments);
}

}  // namespace offmap::core
