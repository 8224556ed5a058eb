// SPDX-License-Identifier: BSD-3-Clause
#include "ByProcessor.h"
#include "Lanes.h"

#include <offmap/core/VerticalSegments.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Makes segments of pieces that stand upright.
class Uprights {
 public:
    Uprights(const LevelledScan& levelled, double maxTilt)
        : levelled_(levelled), maxTilt_(maxTilt), maxSlope_(std::tan(maxTilt) * (1 + rounding)) {}

    /// \param begin of the points that the piece counts from
    std::optional<VerticalSegment> segmentOf(const LinePiece& piece, uint32_t column,
                                             uint32_t begin) const {
        const double aside = std::abs(piece.line.direction.x);
        const double upwards = std::abs(piece.line.direction.y);
        if (aside > upwards * maxSlope_) return std::nullopt;  // most floors: no angle is needed
        VerticalSegment segment{};
        segment.tilt = std::atan2(aside, upwards);
        if (segment.tilt > maxTilt_) return std::nullopt;
        segment.column = column;
        segment.begin = begin + piece.begin;
        segment.end = begin + piece.end;
        addEnds(piece, segment);
        return segment;
    }

 private:
    static constexpr double rounding = 1e-9;

    static Eigen::Array2f floats(const TPoint2D& p) {
        return {static_cast<float>(p.x), static_cast<float>(p.y)};
    }
    void addEnds(const LinePiece& piece, VerticalSegment& segment) const {
        const uint32_t count = segment.end - segment.begin;
        const Eigen::Array2f point = floats(piece.line.point),
                             direction = floats(piece.line.direction);
        const PlanePoints profile = levelled_.profile(segment.begin, segment.end);
        const auto along = (arrayOf(profile.x) - point.x()) * direction.x() +
                           (arrayOf(profile.y) - point.y()) * direction.y();
        segment.bottom = piece.line.at(static_cast<double>(along.minCoeff()));
        segment.top = piece.line.at(static_cast<double>(along.maxCoeff()));
        if (segment.bottom.y > segment.top.y) std::swap(segment.bottom, segment.top);
        segment.centre =
            centreOf(levelled_.x.data() + segment.begin, levelled_.y.data() + segment.begin, count);
    }

    const LevelledScan& levelled_;
    double maxTilt_, maxSlope_;  // [rad], [-]
};

/// What noise beyond the tolerance asks for; nothing where the scan tells of none.
void findSlack(const OrganizedScan& scan, double maxPointToLine, std::vector<float>& slack) {
    constexpr double sigmas = 3;
    slack.clear();
    for (const double sigma : scan.rangeSigma) {
        slack.push_back(static_cast<float>(std::max(sigmas * sigma - maxPointToLine, 0.0)));
    }
}

}  // namespace

void findVerticalSegments(const OrganizedScan& scan, const LevelledScan& levelled,
                          const VerticalConfig& config, SplitAndMergeScratch& scratch,
                          std::vector<VerticalSegment>& segments) {
    SplitAndMergeConfig splitting{config.maxPointToLine, config.maxGap, config.minLength,
                                  config.minPoints};
    findSlack(scan, config.maxPointToLine, scratch.slack);
    const Uprights uprights(levelled, config.maxTilt);
    segments.clear();
    for (uint32_t c = 0; c < scan.columns.size(); ++c) {
        const ScanColumn& column = scan.columns[c];
        if (column.end - column.begin < config.minPoints) continue;
        const PlanePoints profile = levelled.profile(column.begin, column.end);
        if (!scratch.slack.empty()) {
            splitting.slack = std::span(scratch.slack).subspan(column.begin, profile.size());
        }
        for (const LinePiece& piece : splitAndMerge(profile, splitting, scratch)) {
            const auto segment = uprights.segmentOf(piece, c, column.begin);
            if (segment) segments.push_back(*segment);
        }
    }
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
