// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/VerticalSegments.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

VerticalSegment segmentOf(const LinePiece& piece, uint32_t column, uint32_t begin,
                          const LevelledScan& levelled) {
    VerticalSegment segment{};
    segment.column = column;
    segment.begin = begin + piece.begin;
    segment.end = begin + piece.end;
    double low = 0, high = 0;  // piece.line.point is the points' mean, so 0 lies between
    TPoint2D sum(0, 0);
    for (uint32_t i = segment.begin; i < segment.end; ++i) {
        const double coordinate = piece.line.along(levelled.profile[i]);
        low = std::min(low, coordinate);
        high = std::max(high, coordinate);
        sum += levelled.ground[i];
    }
    segment.bottom = piece.line.at(low);
    segment.top = piece.line.at(high);
    if (segment.bottom.y > segment.top.y) std::swap(segment.bottom, segment.top);
    segment.tilt = std::atan2(std::abs(piece.line.direction.x), std::abs(piece.line.direction.y));
    segment.centre = sum * (1.0 / (segment.end - segment.begin));
    return segment;
}

/// What noise beyond the tolerance asks for; nothing where the scan tells of none.
std::vector<float> slackOf(const OrganizedScan& scan, double maxPointToLine) {
    constexpr double sigmas = 3;
    std::vector<float> slack;
    slack.reserve(scan.rangeSigma.size());
    for (const double sigma : scan.rangeSigma) {
        slack.push_back(static_cast<float>(std::max(sigmas * sigma - maxPointToLine, 0.0)));
    }
    return slack;
}

}  // namespace

void findVerticalSegments(const OrganizedScan& scan, const LevelledScan& levelled,
                          const VerticalConfig& config, SplitAndMergeScratch& scratch,
                          std::vector<VerticalSegment>& segments) {
    SplitAndMergeConfig splitting{config.maxPointToLine, config.maxGap, config.minLength,
                                  config.minPoints};
    const std::vector<float> slack = slackOf(scan, config.maxPointToLine);
    segments.clear();
    for (uint32_t c = 0; c < scan.columns.size(); ++c) {
        const ScanColumn& column = scan.columns[c];
        if (column.end - column.begin < config.minPoints) continue;
        const std::span profile(levelled.profile.data() + column.begin, column.end - column.begin);
        if (!slack.empty())
            splitting.slack = std::span(slack).subspan(column.begin, profile.size());
        for (const LinePiece& piece : splitAndMerge(profile, splitting, scratch)) {
            const VerticalSegment segment = segmentOf(piece, c, column.begin, levelled);
            if (segment.tilt <= config.maxTilt) segments.push_back(segment);
        }
    }
}

Interval groundInterval(const VerticalSegment& segment, const LevelledScan& levelled,
                        const GroundIntervalConfig& config) {
    const TPoint2D first = levelled.profile[segment.begin];
    double min = first.x, max = first.x;  // eq. 3
    double height = 0;                    // of the end furthest above or below the sensor
    for (uint32_t i = segment.begin; i < segment.end; ++i) {
        const TPoint2D& p = levelled.profile[i];
        min = std::min(min, p.x);
        max = std::max(max, p.x);
        height = std::max(height, std::abs(p.y));
    }
    return Interval(min, max).expanded(height * std::tan(config.maxMountingTilt));  // eqs. 4, 5
}

}  // namespace offmap::core
