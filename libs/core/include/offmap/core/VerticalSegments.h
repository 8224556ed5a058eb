// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LevelledScan.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/SplitAndMerge.h>

#include <algorithm>
#include <vector>

namespace offmap::core {

/// Finds the vertical line segments of columns (section 3): split-and-merge in the (ground range,
/// z) plane, then the bound eta on the tilt. Keeps its working memory.
class VerticalSegmentFinder {
 public:
    explicit VerticalSegmentFinder(const VerticalConfig& config);

    /// Appends the segments of one column, bottom to top. \param levelled that column, at least
    void addColumn(const OrganizedScan& scan, const LevelledScan& levelled, uint32_t column,
                   std::vector<VerticalSegment>& segments);

    /// Those of all columns.
    void find(const OrganizedScan& scan, const LevelledScan& levelled,
              std::vector<VerticalSegment>& segments);

 private:
    void findSlack(std::span<const float> rangeSigma);

    VerticalConfig config_;
    double maxSlope_;           // [-] tangent of the largest tilt
    std::vector<float> slack_;  // [m] of the column's points
    SplitAndMergeScratch scratch_;
};

/// The interval of ground range that a segment's points span, widened by what a tilted mounting
/// does to its higher or lower end (eqs. 3 to 5) [m].
/// \param maxMountingSlope tangent of GroundIntervalConfig::maxMountingTilt
inline Interval groundInterval(const VerticalSegment& segment, double maxMountingSlope) {
    // Of the end furthest from the sensor's height.
    const double height = std::max(-segment.lowest, segment.highest);
    const double margin = height * maxMountingSlope;               // eqs. 4, 5
    return {segment.nearest - margin, segment.furthest + margin};  // eq. 3
}

}  // namespace offmap::core
