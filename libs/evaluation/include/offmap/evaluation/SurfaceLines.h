// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/SeenSegments.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::evaluation {

struct SurfaceLineConfig {
    double maxPointToLine = 0.05;  ///< [m] of a segment to its line
    double maxGap = 0.5;           ///< [m] between neighbouring segments
    double minLength = 0.3;        ///< [m]
    uint32_t minSegments = 4;
    uint32_t maxColumnGap = 3;  ///< columns without a segment of the line
};

/// A straight piece of a surface that one scan shows, in top view.
struct SurfaceLine {
    std::vector<uint32_t> segments;  ///< indices into those given, by column
    mrpt::math::TPoint2D direction;  ///< unit vector along it
};

/// The horizontal lines that segments of neighbouring columns lie on (split-and-merge of chains of
/// segments, each of which follows the one in the column before that is nearest).
/// \param segments by column
std::vector<SurfaceLine> surfaceLines(std::span<const SeenSegment> segments,
                                      const SurfaceLineConfig& config);

}  // namespace offmap::evaluation
