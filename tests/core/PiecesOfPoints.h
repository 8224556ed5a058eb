// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/SplitAndMerge.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace offmap::core {

using Ranges = std::vector<std::pair<uint32_t, uint32_t>>;

inline constexpr SplitAndMergeConfig config{0.05, 0.5, 0.3, 4};

inline std::vector<LinePiece> piecesOf(const std::vector<mrpt::math::TPoint2D>& points,
                                       const SplitAndMergeConfig& c = config) {
    SplitAndMergeScratch scratch;
    const auto pieces = splitAndMerge(points, c, scratch);
    return {pieces.begin(), pieces.end()};
}

inline Ranges rangesOf(const std::vector<LinePiece>& pieces) {
    Ranges ranges;
    for (const LinePiece& piece : pieces) ranges.emplace_back(piece.begin, piece.end);
    return ranges;
}

/// Appends points from one to another, the first left out if it is there already.
inline void addLine(std::vector<mrpt::math::TPoint2D>& points, const mrpt::math::TPoint2D& from,
                    const mrpt::math::TPoint2D& to, int steps) {
    for (int i = points.empty() ? 0 : 1; i <= steps; ++i) {
        points.push_back(from + (to - from) * (double(i) / steps));
    }
}

inline std::vector<mrpt::math::TPoint2D> line(const mrpt::math::TPoint2D& from,
                                              const mrpt::math::TPoint2D& to, int steps) {
    std::vector<mrpt::math::TPoint2D> points;
    addLine(points, from, to, steps);
    return points;
}

}  // namespace offmap::core
