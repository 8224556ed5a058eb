// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LevelledScan.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/SplitAndMerge.h>

#include <vector>

namespace offmap::core {

/// The vertical line segments of every column, by column and bottom to top (section 3):
/// split-and-merge in the (ground range, z) plane, then the bound eta on the tilt.
void findVerticalSegments(const OrganizedScan& scan, const LevelledScan& levelled,
                          const VerticalConfig& config, SplitAndMergeScratch& scratch,
                          std::vector<VerticalSegment>& segments);

/// The interval of ground range that a segment's points span, widened by what a tilted mounting
/// does to its higher or lower end (eqs. 3 to 5) [m].
/// \param maxMountingSlope tangent of GroundIntervalConfig::maxMountingTilt
Interval groundInterval(const VerticalSegment& segment, const LevelledScan& levelled,
                        double maxMountingSlope);

}  // namespace offmap::core
