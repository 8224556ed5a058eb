// SPDX-License-Identifier: BSD-3-Clause
#include "RootOfSquares.h"

#include <offmap/core/HorizontalExtension.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

/// A horizontal line of matched segments that is being extended.
struct HorizontalLine {
    LineFit fit;
    uint32_t wall;
};

class Extender {
 public:
    Extender(const ColumnRing& ring, std::span<const VerticalSegment> segments,
             const SegmentsByColumn& byColumn, std::span<const std::optional<Viewpoint>> viewpoints,
             const LineMap& map, const ReductionConfig& config, ExtensionScratch& scratch,
             std::span<SegmentMatch> matches)
        : ring_(ring),
          segments_(segments),
          byColumn_(byColumn),
          viewpoints_(viewpoints),
          map_(map),
          config_(config),
          scratch_(scratch),
          matches_(matches) {}

    void extendWall(std::span<uint32_t> matched);

 private:
    void extendChain(std::span<const uint32_t> chain);
    void extend(HorizontalLine& line, uint32_t column, int step);
    bool extendInto(HorizontalLine& line, uint32_t column);
    bool mapConsents(uint32_t segment) const;

    const ColumnRing& ring_;
    std::span<const VerticalSegment> segments_;
    const SegmentsByColumn& byColumn_;
    std::span<const std::optional<Viewpoint>> viewpoints_;
    const LineMap& map_;
    const ReductionConfig& config_;
    ExtensionScratch& scratch_;
    std::span<SegmentMatch> matches_;
};

/// Of one wall's matched segments, makes chains of neighbouring columns. They are turned so that
/// the widest gap lies between the last and the first: then no chain runs across the end of the
/// turn.
void Extender::extendWall(std::span<uint32_t> matched) {
    const auto columnOf = [&](uint32_t s) { return segments_[s].column; };
    size_t first = 0;
    uint32_t widest = 0;
    for (size_t i = 0; i < matched.size(); ++i) {
        const uint32_t before = matched[i == 0 ? matched.size() - 1 : i - 1];
        const uint32_t gap = ring_.stepsBetween(columnOf(before), columnOf(matched[i]));
        if (gap > widest) {
            widest = gap;
            first = i;
        }
    }
    std::rotate(matched.begin(), matched.begin() + static_cast<std::ptrdiff_t>(first),
                matched.end());
    for (size_t begin = 0, i = 1; i <= matched.size(); ++i) {
        const bool chainEnds = i == matched.size() ||
                               ring_.stepsBetween(columnOf(matched[i - 1]), columnOf(matched[i])) >
                                   config_.extension.maxColumnGap + 1;
        if (!chainEnds) continue;
        extendChain(matched.subspan(begin, i - begin));
        begin = i;
    }
}

void Extender::extendChain(std::span<const uint32_t> chain) {
    const ExtensionConfig& config = config_.extension;
    if (chain.size() < config.minSegments) return;
    scratch_.chain.clear();
    for (const uint32_t s : chain) scratch_.chain.push_back(byColumn_.centreInMap(s));
    const SplitAndMergeConfig splitting{config.maxPointToLine,
                                        std::numeric_limits<double>::infinity(), config.minLength,
                                        config.minSegments};
    const std::span<const TPoint2D> centres = scratch_.chain;
    for (const LinePiece& piece : splitAndMerge(centres, splitting, scratch_.splitting)) {
        HorizontalLine line{fitOf(centres.subspan(piece.begin, piece.end - piece.begin)),
                            *matches_[chain[piece.begin]].wall};
        extend(line, segments_[chain[piece.end - 1]].column, +1);
        extend(line, segments_[chain[piece.begin]].column, -1);
    }
}

void Extender::extend(HorizontalLine& line, uint32_t column, int step) {
    const uint32_t start = column;
    uint32_t gap = 0;
    while (gap <= config_.extension.maxColumnGap) {
        const auto next = ring_.neighbour(column, step);
        if (!next || *next == start) return;
        column = *next;
        gap = extendInto(line, column) ? 0 : gap + 1;
    }
}

/// Whether a segment of the column continues the line; those not matched so far become mapped.
bool Extender::extendInto(HorizontalLine& line, uint32_t column) {
    bool continued = false;
    const auto [begin, end] = byColumn_.of(column);
    for (uint32_t s = begin; s < end; ++s) {
        SegmentMatch& match = matches_[s];
        if (match.reason == KeepReason::NoPose) continue;
        if (line.fit.line().distance(byColumn_.centreInMap(s)) > config_.extension.maxPointToLine) {
            continue;
        }
        if (match.verdict == Verdict::Kept) {
            if (config_.extension.mapConsent && !mapConsents(s)) continue;
            match.verdict = Verdict::MappedByExtension;
            match.reason = KeepReason::None;
            match.wall = line.wall;
        }
        line.fit.add(byColumn_.centreInMap(s));
        continued = true;
    }
    return continued;
}

/// Whether a wall stands where the segment does, within what the pose leaves open across that
/// range.
bool Extender::mapConsents(uint32_t s) const {
    const VerticalSegment& segment = segments_[s];
    const Viewpoint& viewpoint = *viewpoints_[segment.column];
    const double bySigmas = config_.matching.sigmaFactor *
                            rootOfSquares(viewpoint.ellipse.semiMajor(),
                                          viewpoint.sigmaHeading * segment.centre.norm());
    const double tolerance =
        config_.extension.maxPointToLine + std::min(bySigmas, config_.matching.maxPositionRadius);
    const double z = viewpoint.height + 0.5 * (segment.bottom.y + segment.top.y);
    return map_.nearestWall(byColumn_.centreInMap(s), tolerance, z).has_value();
}

/// The segments that rays have matched. Neighbours mostly are on one wall, so runs of them are
/// sorted instead of themselves.
void findMatched(std::span<const SegmentMatch> matches, ExtensionScratch& scratch) {
    auto& [matched, runs, ofWall, chain, splitting] = scratch;
    matched.clear();
    runs.clear();
    for (uint32_t s = 0; s < matches.size(); ++s) {
        if (matches[s].verdict != Verdict::MappedByRay) continue;
        const auto at = static_cast<uint32_t>(matched.size());
        if (runs.empty() || runs.back().wall != *matches[s].wall) {
            runs.push_back({*matches[s].wall, at, at});
        }
        matched.push_back(s);
        runs.back().end = at + 1;
    }
    std::ranges::sort(runs, {}, [](const auto& run) { return std::pair(run.wall, run.begin); });
}

}  // namespace

void extendAlongWalls(const ColumnRing& ring, std::span<const VerticalSegment> segments,
                      const SegmentsByColumn& byColumn,
                      std::span<const std::optional<Viewpoint>> viewpoints, const LineMap& map,
                      const ReductionConfig& config, ExtensionScratch& scratch,
                      std::span<SegmentMatch> matches) {
    findMatched(matches, scratch);
    Extender extender(ring, segments, byColumn, viewpoints, map, config, scratch, matches);
    std::vector<uint32_t>& ofWall = scratch.ofWall;
    for (auto run = scratch.runs.begin(); run != scratch.runs.end();) {
        const uint32_t wall = run->wall;
        ofWall.clear();
        for (; run != scratch.runs.end() && run->wall == wall; ++run) {
            ofWall.insert(ofWall.end(), scratch.matched.begin() + run->begin,
                          scratch.matched.begin() + run->end);
        }
        extender.extendWall(ofWall);
    }
}

}  // namespace offmap::core
