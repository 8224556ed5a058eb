// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SplitAndMerge.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;
using Points = std::span<const TPoint2D>;
using Run = SplitAndMergeScratch::Run;

namespace {

bool isGap(const TPoint2D& a, const TPoint2D& b, double maxGap) {
    return (b - a).sqrNorm() > maxGap * maxGap;
}

FittedLine chordOf(Points points, const Run& run) {
    const TPoint2D from = points[run.begin], along = points[run.end - 1] - from;
    const double length = std::sqrt(along.sqrNorm());
    if (length == 0) return {from, {1, 0}};
    return {from, along * (1 / length)};
}

LinePiece pieceOf(Points points, const Run& run) {
    LinePiece piece{run.begin, run.end, {}, {}};
    for (uint32_t i = run.begin; i < run.end; ++i) piece.fit.add(points[i]);
    piece.line = piece.fit.line();
    return piece;
}

/// The point of a run that is furthest from a line, its slack apart, if that is too far; else
/// run.end.
uint32_t strayPoint(Points points, const Run& run, const FittedLine& line,
                    const SplitAndMergeConfig& config) {
    double furthest = config.maxPointToLine;
    uint32_t stray = run.end;
    for (uint32_t i = run.begin; i < run.end; ++i) {
        const double slack = config.slack.empty() ? 0 : static_cast<double>(config.slack[i]);
        const double distance = line.distance(points[i]) - slack;
        if (distance > furthest) {
            furthest = distance;
            stray = i;
        }
    }
    return stray;
}

bool keepsTolerance(Points points, const LinePiece& piece, const SplitAndMergeConfig& config) {
    return strayPoint(points, {piece.begin, piece.end}, piece.line, config) == piece.end;
}

/// Runs without gaps, the last one on top.
void cutAtGaps(Points points, double maxGap, std::vector<Run>& runs) {
    runs.clear();
    uint32_t end = static_cast<uint32_t>(points.size());
    for (uint32_t i = end; i > 0; --i) {
        if (i > 1 && !isGap(points[i - 2], points[i - 1], maxGap)) continue;
        runs.push_back({i - 1, end});
        end = i - 1;
    }
}

/// Merges a piece into the one before it while one line serves both.
void append(Points points, LinePiece piece, const SplitAndMergeConfig& config,
            std::vector<LinePiece>& pieces) {
    while (!pieces.empty() && pieces.back().end == piece.begin &&
           !isGap(points[piece.begin - 1], points[piece.begin], config.maxGap)) {
        LinePiece both = pieces.back();
        both.end = piece.end;
        both.fit.add(piece.fit);
        both.line = both.fit.line();
        if (!keepsTolerance(points, both, config)) break;
        pieces.pop_back();
        piece = both;
    }
    pieces.push_back(piece);
}

/// Splitting gives the points beside a corner to one piece or the other as the order has it. Moves
/// the seam of two pieces, so that each point there belongs to the line it is nearer to.
void settleSeam(Points points, const SplitAndMergeConfig& config, LinePiece& first,
                LinePiece& second) {
    uint32_t seam = first.end;
    if (isGap(points[seam - 1], points[seam], config.maxGap)) return;
    const auto claims = [&](const LinePiece& piece, const LinePiece& other, uint32_t i) {
        return piece.end - piece.begin >= config.minPoints &&
               piece.line.distance(points[i]) < other.line.distance(points[i]);
    };
    while (seam + 1 < second.end && claims(first, second, seam)) ++seam;
    while (seam - 1 > first.begin && claims(second, first, seam - 1)) --seam;
    if (seam == first.end) return;
    const LinePiece before = pieceOf(points, {first.begin, seam});
    const LinePiece after = pieceOf(points, {seam, second.end});
    if (keepsTolerance(points, before, config) && keepsTolerance(points, after, config)) {
        first = before;
        second = after;
    }
}

bool longEnough(Points points, const LinePiece& piece, const SplitAndMergeConfig& config) {
    if (piece.end - piece.begin < config.minPoints) return false;
    double low = piece.line.along(points[piece.begin]), high = low;
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
        const double coordinate = piece.line.along(points[i]);
        low = std::min(low, coordinate);
        high = std::max(high, coordinate);
    }
    return high - low >= config.minLength;
}

}  // namespace

std::span<const LinePiece> splitAndMerge(Points points, const SplitAndMergeConfig& config,
                                         SplitAndMergeScratch& scratch) {
    auto& [pending, pieces] = scratch;
    pieces.clear();
    cutAtGaps(points, config.maxGap, pending);
    while (!pending.empty()) {
        const Run run = pending.back();
        pending.pop_back();
        uint32_t at = strayPoint(points, run, chordOf(points, run), config);
        if (at == run.end) {
            const LinePiece piece = pieceOf(points, run);
            at = strayPoint(points, run, piece.line, config);
            if (at == run.end) {
                append(points, piece, config, pieces);
                continue;
            }
        }
        // The stray point begins the second part, unless it is the first of the run.
        at = std::max(at, run.begin + 1);
        pending.push_back({at, run.end});
        pending.push_back({run.begin, at});
    }
    for (size_t i = 1; i < pieces.size(); ++i) {
        settleSeam(points, config, pieces[i - 1], pieces[i]);
    }
    std::erase_if(pieces,
                  [&](const LinePiece& piece) { return !longEnough(points, piece, config); });
    return pieces;
}

}  // namespace offmap::core
