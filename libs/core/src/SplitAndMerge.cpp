// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SplitAndMerge.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;
using Points = std::span<const TPoint2D>;
using Run = SplitAndMergeScratch::Run;

namespace {

FittedLine chordOf(Points points, const Run& run) {
    const TPoint2D from = points[run.begin], to = points[run.end - 1];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length == 0) return {from, {1, 0}};
    return {from, (to - from) * (1 / length)};
}

FittedLine fitTo(Points points, const Run& run) {
    LineFit fit;
    for (uint32_t i = run.begin; i < run.end; ++i) fit.add(points[i]);
    return fit.line();
}

bool allWithin(Points points, const Run& run, const FittedLine& line, double distance) {
    return std::all_of(points.begin() + run.begin, points.begin() + run.end,
                       [&](const TPoint2D& p) { return line.distance(p) <= distance; });
}

/// Where a run has to be cut: at the point furthest from the chord of its ends, or else from the
/// line fitted to it, if that is too far. The point begins the second part, unless it is the first
/// of the run. run.end: nowhere.
uint32_t splitPoint(Points points, const Run& run, double maxPointToLine) {
    uint32_t at = run.end;
    const auto lookAlong = [&](const FittedLine& line) {
        double furthest = maxPointToLine;
        for (uint32_t i = run.begin; i < run.end; ++i) {
            const double distance = line.distance(points[i]);
            if (distance > furthest) {
                furthest = distance;
                at = std::max(i, run.begin + 1);
            }
        }
    };
    lookAlong(chordOf(points, run));
    if (at == run.end) lookAlong(fitTo(points, run));
    return at;
}

/// Runs without gaps, the last one on top.
void cutAtGaps(Points points, double maxGap, std::vector<Run>& runs) {
    runs.clear();
    uint32_t end = static_cast<uint32_t>(points.size());
    for (uint32_t i = end; i > 0; --i) {
        const bool gap = i == 1 || std::hypot(points[i - 1].x - points[i - 2].x,
                                              points[i - 1].y - points[i - 2].y) > maxGap;
        if (!gap) continue;
        runs.push_back({i - 1, end});
        end = i - 1;
    }
}

/// Merges a piece into the one before it while one line serves both.
void append(Points points, const Run& run, const SplitAndMergeConfig& config,
            std::vector<LinePiece>& pieces) {
    LinePiece piece{run.begin, run.end, fitTo(points, run)};
    while (!pieces.empty() && pieces.back().end == piece.begin) {
        const Run both{pieces.back().begin, piece.end};
        const TPoint2D seam = points[piece.begin] - points[piece.begin - 1];
        if (std::hypot(seam.x, seam.y) > config.maxGap) break;
        const FittedLine line = fitTo(points, both);
        if (!allWithin(points, both, line, config.maxPointToLine)) break;
        pieces.pop_back();
        piece = {both.begin, both.end, line};
    }
    pieces.push_back(piece);
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
        const uint32_t at = splitPoint(points, run, config.maxPointToLine);
        if (at == run.end) {
            append(points, run, config, pieces);
        } else {
            pending.push_back({at, run.end});
            pending.push_back({run.begin, at});
        }
    }
    std::erase_if(pieces,
                  [&](const LinePiece& piece) { return !longEnough(points, piece, config); });
    return pieces;
}

}  // namespace offmap::core
