// SPDX-License-Identifier: BSD-3-Clause
#include "OffsetsFromLine.h"

#include <offmap/core/SplitAndMerge.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;
using Run = SplitAndMergeScratch::Run;

namespace {

/// What is split: points, and how far each may be off.
class Splitting {
 public:
    Splitting(const PlanePoints& points, const SplitAndMergeConfig& config, const RangeFits& fits)
        : points_(points), config_(config), fits_(fits) {}

    void cutAtGaps(std::vector<Run>& runs) const;
    uint32_t strayFromChord(const Run& run) const;
    uint32_t strayFromFit(const Run& run) const;
    LinePiece pieceOf(const Run& run) const;
    void append(Run run, std::vector<Run>& straight) const;
    void settleSeam(LinePiece& first, LinePiece& second) const;
    bool longEnough(const LinePiece& piece) const;

 private:
    static constexpr uint32_t gapBlock = 8;  // steps that are looked at together

    bool isGap(uint32_t before) const {
        return (points_[before + 1] - points_[before]).sqrNorm() > config_.maxGap * config_.maxGap;
    }
    bool anyGapBehind(uint32_t first) const;
    OffsetsFromLine offsets(const Run& run, const ScaledLine& line) const;
    bool keepsTolerance(const Run& run) const;
    bool mayBeStraight(uint32_t first, uint32_t between, uint32_t last) const;

    const PlanePoints& points_;
    const SplitAndMergeConfig& config_;
    const RangeFits& fits_;
};

/// Whether there is a gap behind any of some points from `first` on.
bool Splitting::anyGapBehind(uint32_t first) const {
    using Block = Eigen::Array<double, gapBlock, 1>;
    using At = Eigen::Map<const Block>;
    const double *x = points_.x.data() + first, *y = points_.y.data() + first;
    const Block stepX = At(x + 1) - At(x), stepY = At(y + 1) - At(y);
    return (stepX * stepX + stepY * stepY).maxCoeff() > config_.maxGap * config_.maxGap;
}

/// Runs without gaps that are worth a look, the first one on top.
void Splitting::cutAtGaps(std::vector<Run>& runs) const {
    runs.clear();
    auto end = static_cast<uint32_t>(points_.size());
    const auto cut = [&](uint32_t begin) {
        if (end - begin >= std::max(config_.minPoints, 1u)) runs.push_back({begin, end});
        end = begin;
    };
    for (uint32_t i = end; i > 1;) {
        const uint32_t stop = i > gapBlock ? i - gapBlock : 1;
        if (i > gapBlock && !anyGapBehind(stop - 1)) {
            i = stop;
            continue;
        }
        for (; i > stop; --i) {
            if (isGap(i - 2)) cut(i - 1);
        }
    }
    cut(0);
}

OffsetsFromLine Splitting::offsets(const Run& run, const ScaledLine& line) const {
    const auto slack = config_.slack.empty()
                           ? config_.slack
                           : config_.slack.subspan(run.begin, run.end - run.begin);
    return {points_.range(run.begin, run.end), slack, line};
}

/// The point of a run that is furthest from the chord of its ends, its slack apart, if that is too
/// far; else run.end.
uint32_t Splitting::strayFromChord(const Run& run) const {
    if (run.end - run.begin <= 2) return run.end;
    const TPoint2D from = points_[run.begin], along = points_[run.end - 1] - from;
    const double length = std::sqrt(along.sqrNorm());
    const ScaledLine chord =
        length > 0 ? ScaledLine{from, along, length} : ScaledLine{from, {1, 0}, 1};
    return run.begin + offsets(run, chord).furthestBeyond(config_.maxPointToLine);
}

/// The same of its fitted line.
uint32_t Splitting::strayFromFit(const Run& run) const {
    if (run.end - run.begin <= 2) return run.end;
    const ScaledLine line = fits_.of(run.begin, run.end).scaledLine();
    return run.begin + offsets(run, line).furthestBeyond(config_.maxPointToLine);
}

/// Whether the fitted line of a run serves it.
bool Splitting::keepsTolerance(const Run& run) const {
    const ScaledLine line = fits_.of(run.begin, run.end).scaledLine();
    return !offsets(run, line).anyBeyond(config_.maxPointToLine);
}

LinePiece Splitting::pieceOf(const Run& run) const {
    LinePiece piece{run.begin, run.end, fits_.of(run.begin, run.end), {}};
    piece.line = piece.fit.line();
    return piece;
}

/// Three points that one line serves form a triangle no higher than twice the tolerance: most
/// corners are told so, without a fit.
bool Splitting::mayBeStraight(uint32_t first, uint32_t between, uint32_t last) const {
    if (!config_.slack.empty()) return true;
    const TPoint2D toBetween = points_[between] - points_[first];
    const TPoint2D toLast = points_[last] - points_[first];
    const double twiceArea = toBetween.x * toLast.y - toBetween.y * toLast.x;
    const double longest =
        std::max({toBetween.sqrNorm(), toLast.sqrNorm(), (toLast - toBetween).sqrNorm()});
    constexpr double rounding = 1 + 1e-9;
    const double highest = 2 * rounding * config_.maxPointToLine;
    return twiceArea * twiceArea <= highest * highest * longest;
}

/// Merges a straight run with the ones before it while one line serves both.
void Splitting::append(Run run, std::vector<Run>& straight) const {
    while (!straight.empty() && straight.back().end == run.begin && !isGap(run.begin - 1)) {
        const Run both{straight.back().begin, run.end};
        if (!mayBeStraight(both.begin, run.begin, both.end - 1) || !keepsTolerance(both)) break;
        straight.pop_back();
        run = both;
    }
    straight.push_back(run);
}

/// Splitting gives the points beside a corner to one piece or the other as the order has it. Moves
/// the seam of two pieces, so that each point there belongs to the line it is nearer to.
void Splitting::settleSeam(LinePiece& first, LinePiece& second) const {
    uint32_t seam = first.end;
    if (seam != second.begin || isGap(seam - 1)) return;
    const auto claims = [&](const LinePiece& piece, const LinePiece& other, uint32_t i) {
        return piece.end - piece.begin >= config_.minPoints &&
               piece.line.distance(points_[i]) < other.line.distance(points_[i]);
    };
    while (seam + 1 < second.end && claims(first, second, seam)) ++seam;
    while (seam - 1 > first.begin && claims(second, first, seam - 1)) --seam;
    if (seam == first.end) return;
    const Run before{first.begin, seam}, after{seam, second.end};
    if (!keepsTolerance(before) || !keepsTolerance(after)) return;
    first = pieceOf(before);
    second = pieceOf(after);
}

bool Splitting::longEnough(const LinePiece& piece) const {
    if (piece.end - piece.begin < config_.minPoints) return false;
    const double first = piece.line.along(points_[piece.begin]);
    if (std::abs(piece.line.along(points_[piece.end - 1]) - first) >= config_.minLength)
        return true;
    double low = first, high = first;
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
        const double coordinate = piece.line.along(points_[i]);
        low = std::min(low, coordinate);
        high = std::max(high, coordinate);
    }
    return high - low >= config_.minLength;
}

}  // namespace

std::span<const LinePiece> splitAndMerge(const PlanePoints& points,
                                         const SplitAndMergeConfig& config,
                                         SplitAndMergeScratch& scratch) {
    scratch.fits.build(points);
    const Splitting splitting(points, config, scratch.fits);
    auto& pending = scratch.pending;
    auto& straight = scratch.straight;
    auto& pieces = scratch.pieces;
    straight.clear();
    pieces.clear();
    splitting.cutAtGaps(pending);
    while (!pending.empty()) {
        const Run run = pending.back();
        pending.pop_back();
        uint32_t at = splitting.strayFromChord(run);
        if (at == run.end) at = splitting.strayFromFit(run);
        if (at == run.end) {
            splitting.append(run, straight);
            continue;
        }
        // The stray point begins the second part, unless it is the first of the run.
        at = std::max(at, run.begin + 1);
        pending.push_back({at, run.end});
        pending.push_back({run.begin, at});
    }
    for (const Run& run : straight) pieces.push_back(splitting.pieceOf(run));
    for (size_t i = 1; i < pieces.size(); ++i) splitting.settleSeam(pieces[i - 1], pieces[i]);
    std::erase_if(pieces, [&](const LinePiece& piece) { return !splitting.longEnough(piece); });
    return pieces;
}

std::span<const LinePiece> splitAndMerge(std::span<const TPoint2D> points,
                                         const SplitAndMergeConfig& config,
                                         SplitAndMergeScratch& scratch) {
    scratch.x.clear();
    scratch.y.clear();
    for (const TPoint2D& p : points) {
        scratch.x.push_back(p.x);
        scratch.y.push_back(p.y);
    }
    return splitAndMerge({scratch.x, scratch.y}, config, scratch);
}

}  // namespace offmap::core
