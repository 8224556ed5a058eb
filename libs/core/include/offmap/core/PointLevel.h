// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LevelledScan.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/PoseCorrection.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/WallGate.h>

#include <span>

namespace offmap::core {

/// How single returns of a scan stand to walls, once its poses are corrected.
class ReturnOffsets {
 public:
    ReturnOffsets(const OrganizedScan& scan, const LevelledScan& levelled,
                  const PoseCorrection& correction, const LineMap& map,
                  const AlignmentConfig& config)
        : scan_(scan), levelled_(levelled), correction_(correction), map_(map), config_(config) {}

    /// \param place of the return's column
    WallOffset of(uint32_t point, const ColumnPlace& place, uint32_t wall) const;

    const OrganizedScan& scan() const { return scan_; }
    const LevelledScan& levelled() const { return levelled_; }
    const AlignmentConfig& config() const { return config_; }

 private:
    const OrganizedScan& scan_;
    const LevelledScan& levelled_;
    const PoseCorrection& correction_;
    const LineMap& map_;
    const AlignmentConfig& config_;
};

/// A wall that segments of a column were removed with, and between which heights.
struct RemovedWall {
    uint32_t wall;
    double low, high;  ///< [m] above the sensor
};

/// Labels as mapped what lies on no vertical segment but on a wall that segments of the same or a
/// near column were removed with, between their heights: scraps of wall beside an occluder.
void labelLooseReturns(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                       std::span<const SegmentMatch> matches, std::span<PointLabel> labels);

/// Labels as kept each run of returns of a removed segment whose mean stands off the wall by more
/// than can be by chance: something thin before the wall, that split-and-merge took for it.
void keepRunsOffTheWall(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                        std::span<const SegmentMatch> matches, std::span<PointLabel> labels);

}  // namespace offmap::core
