// SPDX-License-Identifier: BSD-3-Clause
#include "Merging.h"
#include "Splitting.h"

#include <offmap/core/ByProcessor.h>
#include <offmap/core/SplitAndMerge.h>

#include <algorithm>
#include <cmath>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

bool steepEnough(const ScaledLine& line, double maxSlope) {
    return std::isinf(maxSlope) || std::abs(line.along.x) <= std::abs(line.along.y) * maxSlope;
}

bool longEnough(const LinePiece& piece, const PlanePoints& points, double minLength) {
    const double first = piece.line.along(points[piece.begin]);
    if (std::abs(piece.line.along(points[piece.end - 1]) - first) >= minLength) return true;
    double low = first, high = first;
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
        const double coordinate = piece.line.along(points[i]);
        low = std::min(low, coordinate);
        high = std::max(high, coordinate);
    }
    return high - low >= minLength;
}

}  // namespace

OFFMAP_BY_PROCESSOR [[gnu::flatten]] std::span<const LinePiece> splitAndMerge(
    const PlanePoints& points, const SplitAndMergeConfig& config, SplitAndMergeScratch& scratch) {
    const RunLines lines(points, config);
    Splitting splitting(lines, scratch.pending);
    Merging merging(lines, scratch.straight);
    while (!splitting.done()) merging.append(splitting.next());
    merging.settleSeams();
    scratch.pieces.clear();
    for (const StraightRun& run : scratch.straight) {
        if (run.size() < config.minPoints || !steepEnough(run.line, config.maxSlope)) continue;
        const LinePiece piece{run.begin, run.end, run.line.withUnitVector()};
        if (longEnough(piece, points, config.minLength)) scratch.pieces.push_back(piece);
    }
    return scratch.pieces;
}

std::span<const LinePiece> splitAndMerge(std::span<const TPoint2D> points,
                                         const SplitAndMergeConfig& config,
                                         SplitAndMergeScratch& scratch) {
    scratch.x.clear();
    scratch.y.clear();
    for (const TPoint2D& p : points) {
        scratch.x.push_back(static_cast<float>(p.x - points.front().x));
        scratch.y.push_back(static_cast<float>(p.y - points.front().y));
    }
    splitAndMerge({scratch.x, scratch.y}, config, scratch);
    for (LinePiece& piece : scratch.pieces) {
        piece.line = fitOf(points.subspan(piece.begin, piece.end - piece.begin)).line();
    }
    return scratch.pieces;
}

}  // namespace offmap::core
