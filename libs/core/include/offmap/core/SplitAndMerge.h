// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineFit.h>
#include <offmap/core/PlanePoints.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace offmap::core {

struct SplitAndMergeConfig {
    double maxPointToLine;           ///< [m] of any point of a piece to its line
    double maxGap;                   ///< [m] between neighbouring points of a piece
    double minLength;                ///< [m] between the ends of a piece, along its line
    uint32_t minPoints;              ///< of a piece
    std::span<const float> slack{};  ///< [m] per point, on top of maxPointToLine; empty: none
    /// [-] x per y, without signs, of a piece's line: what lies flatter is no piece.
    double maxSlope = std::numeric_limits<double>::infinity();
};

/// A straight piece of an ordered list of points.
struct LinePiece {
    uint32_t begin, end;  ///< half-open range into the points
    FittedLine line;      ///< of least squared distances to them
};

/// Working memory, and the owner of the result.
struct SplitAndMergeScratch {
    /// Points that follow each other without a gap, and their sums: of none, until they are needed.
    struct Run {
        LineSums sums;
        uint32_t begin, end;

        uint32_t size() const { return end - begin; }
    };
    /// With the line that serves it.
    struct StraightRun : Run {
        ScaledLine line;
    };
    std::vector<Run> pending;
    std::vector<StraightRun> straight;
    std::vector<LinePiece> pieces;
    std::vector<float> x, y;  ///< [m] of points that came pair by pair, from the first of them
};

/// Straight pieces of an ordered list of points, in its order and disjoint: the list is cut at
/// gaps, a run that its fitted line does not serve is split at a point that strays from that line
/// alone, else at the one furthest from the chord of its ends, and neighbouring pieces are merged
/// while one fitted line serves both; then each point beside the seam of two pieces goes to the
/// nearer line (section 2: Borges 2000, Nguyen 2005). \return valid until the scratch is used again
std::span<const LinePiece> splitAndMerge(const PlanePoints& points,
                                         const SplitAndMergeConfig& config,
                                         SplitAndMergeScratch& scratch);
std::span<const LinePiece> splitAndMerge(std::span<const mrpt::math::TPoint2D> points,
                                         const SplitAndMergeConfig& config,
                                         SplitAndMergeScratch& scratch);

}  // namespace offmap::core
