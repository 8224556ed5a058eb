// SPDX-License-Identifier: BSD-3-Clause
#include "Lanes.h"
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
    Splitting(const PlanePoints& points, const SplitAndMergeConfig& config)
        : points_(points), config_(config) {}

    void cutAtGaps(std::vector<Run>& runs) const;
    uint32_t strayFromChord(const Run& run) const;
    uint32_t strayFromLine(const LinePiece& piece) const;
    LinePiece pieceOf(const Run& run) const;
    void append(LinePiece piece, std::vector<LinePiece>& pieces) const;
    void settleSeam(LinePiece& first, LinePiece& second) const;
    bool longEnough(const LinePiece& piece) const;

 private:
    bool isGap(uint32_t before) const {
        return (points_[before + 1] - points_[before]).sqrNorm() > config_.maxGap * config_.maxGap;
    }
    bool anyGap(uint32_t first, uint32_t last) const;
    OffsetsFromLine offsets(const Run& run, const TPoint2D& from, const TPoint2D& along,
                            double length) const;
    bool keepsTolerance(const LinePiece& piece) const;
    bool mayBeOne(const LinePiece& first, const LinePiece& second) const;

    const PlanePoints& points_;
    const SplitAndMergeConfig& config_;
};

/// Whether there is a gap before any of the points from the one after `first` to `last`.
bool Splitting::anyGap(uint32_t first, uint32_t last) const {
    const auto x = arrayOf(points_.x.subspan(first, last - first + 1));
    const auto y = arrayOf(points_.y.subspan(first, last - first + 1));
    const Eigen::Index steps = last - first;
    const double widest =
        ((x.tail(steps) - x.head(steps)).square() + (y.tail(steps) - y.head(steps)).square())
            .maxCoeff();
    return widest > config_.maxGap * config_.maxGap;
}

/// Runs without gaps that are worth a look, the last one on top.
void Splitting::cutAtGaps(std::vector<Run>& runs) const {
    constexpr uint32_t stride = 16;  // points that are looked at together
    runs.clear();
    auto end = static_cast<uint32_t>(points_.size());
    const auto add = [&](uint32_t begin) {
        if (end - begin >= config_.minPoints) runs.push_back({begin, end});
        end = begin;
    };
    for (uint32_t last = end - std::min(end, 1u); last > 0;) {
        const uint32_t first = last - std::min(last, stride);
        if (anyGap(first, last)) {
            for (uint32_t i = last; i > first; --i) {
                if (isGap(i - 1)) add(i);
            }
        }
        last = first;
    }
    if (end > 0) add(0);
}

OffsetsFromLine Splitting::offsets(const Run& run, const TPoint2D& from, const TPoint2D& along,
                                   double length) const {
    const auto slack = config_.slack.empty()
                           ? config_.slack
                           : config_.slack.subspan(run.begin, run.end - run.begin);
    return {points_.range(run.begin, run.end), slack, from, along, length};
}

/// The point of a run that is furthest from the chord of its ends, its slack apart, if that is too
/// far; else run.end.
uint32_t Splitting::strayFromChord(const Run& run) const {
    if (run.end - run.begin <= 2) return run.end;
    const TPoint2D from = points_[run.begin];
    TPoint2D along = points_[run.end - 1] - from;
    double length = std::sqrt(along.sqrNorm());
    if (length == 0) {
        along = {1, 0};
        length = 1;
    }
    return run.begin + offsets(run, from, along, length).furthestBeyond(config_.maxPointToLine);
}

uint32_t Splitting::strayFromLine(const LinePiece& piece) const {
    return piece.begin +
           offsets({piece.begin, piece.end}, piece.line.point, piece.line.direction, 1)
               .furthestBeyond(config_.maxPointToLine);
}

bool Splitting::keepsTolerance(const LinePiece& piece) const {
    return !offsets({piece.begin, piece.end}, piece.line.point, piece.line.direction, 1)
                .anyBeyond(config_.maxPointToLine);
}

LinePiece Splitting::pieceOf(const Run& run) const {
    LinePiece piece{run.begin, run.end, {}, {}};
    piece.fit.add(points_.range(run.begin, run.end));
    piece.line = piece.fit.line();
    return piece;
}

/// Three points that one line serves form a triangle no higher than twice the tolerance: most
/// corners are told by their ends and the seam between, without a fit.
bool Splitting::mayBeOne(const LinePiece& first, const LinePiece& second) const {
    if (!config_.slack.empty()) return true;
    const TPoint2D toSeam = points_[second.begin] - points_[first.begin];
    const TPoint2D toEnd = points_[second.end - 1] - points_[first.begin];
    const double twiceArea = toSeam.x * toEnd.y - toSeam.y * toEnd.x;
    const double longest =
        std::max({toSeam.sqrNorm(), toEnd.sqrNorm(), (toEnd - toSeam).sqrNorm()});
    constexpr double rounding = 1 + 1e-9;
    const double highest = 2 * rounding * config_.maxPointToLine;
    return twiceArea * twiceArea <= highest * highest * longest;
}

/// Merges a piece into the one before it while one line serves both.
void Splitting::append(LinePiece piece, std::vector<LinePiece>& pieces) const {
    while (!pieces.empty() && pieces.back().end == piece.begin && !isGap(piece.begin - 1) &&
           mayBeOne(pieces.back(), piece)) {
        LinePiece both = pieces.back();
        both.end = piece.end;
        both.fit.add(piece.fit);
        both.line = both.fit.line();
        if (!keepsTolerance(both)) break;
        pieces.pop_back();
        piece = both;
    }
    pieces.push_back(piece);
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
    const LinePiece before = pieceOf({first.begin, seam});
    const LinePiece after = pieceOf({seam, second.end});
    if (keepsTolerance(before) && keepsTolerance(after)) {
        first = before;
        second = after;
    }
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
    const Splitting splitting(points, config);
    auto& pending = scratch.pending;
    auto& pieces = scratch.pieces;
    pieces.clear();
    splitting.cutAtGaps(pending);
    while (!pending.empty()) {
        const Run run = pending.back();
        pending.pop_back();
        uint32_t at = splitting.strayFromChord(run);
        if (at == run.end) {
            const LinePiece piece = splitting.pieceOf(run);
            at = splitting.strayFromLine(piece);
            if (at == run.end) {
                splitting.append(piece, pieces);
                continue;
            }
        }
        // The stray point begins the second part, unless it is the first of the run.
        at = std::max(at, run.begin + 1);
        pending.push_back({at, run.end});
        pending.push_back({run.begin, at});
    }
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
