// SPDX-License-Identifier: BSD-3-Clause
#include "ByProcessor.h"
#include "Lanes.h"

#include <offmap/core/VerticalSegments.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

OFFMAP_BY_PROCESSOR TPoint2D centreOf(const float* x, const float* y, uint32_t count) {
    const uint32_t blocks = count / sumCount * sumCount;
    Sums sumsX{}, sumsY{}, more;
    for (uint32_t i = 0; i < blocks; i += sumCount) {
        load(x + i, more);
        sumsX += more;
        load(y + i, more);
        sumsY += more;
    }
    TPoint2D sum(total(sumsX), total(sumsY));
    for (uint32_t i = blocks; i < count; ++i) sum += TPoint2D(x[i], y[i]);
    return sum * (1.0 / count);
}

constexpr double rounding = 1e-9;

/// The ends of a piece, and where it stands.
void measure(const LinePiece& piece, const LevelledScan& levelled, VerticalSegment& segment) {
    const auto floats = [](const TPoint2D& p) {
        return Eigen::Array2f(static_cast<float>(p.x), static_cast<float>(p.y));
    };
    const Eigen::Array2f point = floats(piece.line.point), direction = floats(piece.line.direction);
    const PlanePoints profile = levelled.profile(segment.begin, segment.end);
    const auto along = (arrayOf(profile.x) - point.x()) * direction.x() +
                       (arrayOf(profile.y) - point.y()) * direction.y();
    segment.bottom = piece.line.at(static_cast<double>(along.minCoeff()));
    segment.top = piece.line.at(static_cast<double>(along.maxCoeff()));
    if (segment.bottom.y > segment.top.y) std::swap(segment.bottom, segment.top);
    segment.centre = centreOf(levelled.x.data() + segment.begin, levelled.y.data() + segment.begin,
                              segment.end - segment.begin);
}

}  // namespace

VerticalSegmentFinder::VerticalSegmentFinder(const VerticalConfig& config)
    : config_(config), maxSlope_(std::tan(config.maxTilt) * (1 + rounding)) {}

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
        if (aside > upwards * maxSlope_) continue;  // most floors: no angle is needed
        const double tilt = std::atan2(aside, upwards);
        if (tilt > config_.maxTilt) continue;
        VerticalSegment segment{column, begin + piece.begin, begin + piece.end, {}, {}, tilt, {}};
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
    const auto [range, z] = levelled.profile(segment.begin, segment.end);
    const double nearest = arrayOf(range).minCoeff(), furthest = arrayOf(range).maxCoeff();
    const double height = arrayOf(z).abs().maxCoeff();  // of the end furthest from the sensor's
    const double margin = height * maxMountingSlope;    // eqs. 4, 5
    return {nearest - margin, furthest + margin};       // eq. 3
}

}  // namespace offmap::core
