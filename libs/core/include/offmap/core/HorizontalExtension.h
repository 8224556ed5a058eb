// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ColumnRing.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/MapMatching.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/SegmentsByColumn.h>
#include <offmap/core/SplitAndMerge.h>

#include <mrpt/math/TPoint2D.h>

#include <optional>
#include <span>
#include <vector>

namespace offmap::core {

/// Working memory.
struct ExtensionScratch {
    /// Runs of segments in their order that were matched with one wall, sorted by wall.
    struct RunOnWall {
        uint32_t wall, begin, end;  ///< half-open range into `matched`
    };
    std::vector<uint32_t> matched;  ///< segments by column
    std::vector<RunOnWall> runs;
    std::vector<uint32_t> ofWall;             ///< one wall's matched segments, by column
    std::vector<mrpt::math::TPoint2D> chain;  ///< [m] centres of some of these
    SplitAndMergeScratch splitting;
};

/// Extends horizontal lines of matched segments along the wall, in both directions of rotation
/// (section 3.3): an unmatched segment of the next column whose centre lies on the line is mapped
/// as well, so that a wall met at grazing incidence, where heading makes the range useless, is
/// followed from where it was recognised. \param viewpoints one per column; none: the column has no
/// usable pose
void extendAlongWalls(const ColumnRing& ring, std::span<const VerticalSegment> segments,
                      const SegmentsByColumn& byColumn,
                      std::span<const std::optional<Viewpoint>> viewpoints, const LineMap& map,
                      const ReductionConfig& config, ExtensionScratch& scratch,
                      std::span<SegmentMatch> matches);

}  // namespace offmap::core
