// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LevelledScan.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/PoseCorrection.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/WallGate.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::core {

/// How single returns of a scan stand to walls, once its poses are corrected.
class ReturnOffsets {
 public:
    /// \param places of the scan's columns
    ReturnOffsets(const OrganizedScan& scan, const LevelledScan& levelled,
                  std::span<const ColumnPlace> places, const PoseCorrection& correction,
                  const LineMap& map, const AlignmentConfig& config)
        : scan_(scan),
          levelled_(levelled),
          places_(places),
          correction_(correction),
          turn_(correction),
          map_(map),
          config_(config) {}

    SeenPoint seen(uint32_t point) const { return {levelled_.ground(point), levelled_.z[point]}; }

    /// [m] A return's height above the sensor, the lean not undone.
    double z(uint32_t point) const { return levelled_.z[point]; }
    double groundRange(uint32_t point) const { return levelled_.range[point]; }  ///< [m]

    /// Whether a return stands at a wall, within the gate. \param column of the return
    bool isAt(uint32_t wall, uint32_t point, const CorrectedColumn& column) const;

    /// [m] Of a return's range.
    double sigmaRange(uint32_t point) const {
        return scan_.rangeSigmaOf(point, config_.sigmaRange);
    }

    /// [m] Standard deviation across the wall that all returns of a segment have in common: pose
    /// and map.
    double commonSigma(const VerticalSegment& segment, uint32_t wall) const;

    CorrectedColumn corrected(uint32_t column) const {
        return {correction_, turn_, places_[column]};
    }
    const Wall& wall(uint32_t index) const { return map_.walls()[index]; }
    const LineMap& map() const { return map_; }
    const OrganizedScan& scan() const { return scan_; }
    const LevelledScan& levelled() const { return levelled_; }
    const PoseCorrection& correction() const { return correction_; }
    const ColumnPlace& place(uint32_t column) const { return places_[column]; }
    const AlignmentConfig& config() const { return config_; }

 private:
    const OrganizedScan& scan_;
    const LevelledScan& levelled_;
    std::span<const ColumnPlace> places_;
    const PoseCorrection& correction_;
    Turn turn_;
    const LineMap& map_;
    const AlignmentConfig& config_;
};

/// A wall that segments of a column were removed with, and between which heights.
struct RemovedWall {
    uint32_t wall;     ///< index into LineMap::walls()
    double low, high;  ///< [m] above the sensor
};

/// Working memory.
struct LooseReturnsScratch {
    std::vector<uint32_t> first;         ///< per column, and one more: index of its `removed`
    std::vector<RemovedWall> removed;    ///< by column
    std::vector<RemovedWall> near;       ///< of one column and those beside it
    std::vector<LinearDistance> behind;  ///< of each of `near`
};

/// Labels as mapped what lies on no vertical segment but on a wall that segments of the same or a
/// near column were removed with, between their heights: scraps of wall beside an occluder.
void labelLooseReturns(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                       std::span<const SegmentMatch> matches, LooseReturnsScratch& scratch,
                       std::span<PointLabel> labels);

/// Labels as kept each run of returns of a removed segment whose mean stands off the wall by more
/// than can be by chance: something thin before the wall, that split-and-merge took for it.
void keepRunsOffTheWall(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                        std::span<const SegmentMatch> matches, std::span<PointLabel> labels);

/// Labels as kept returns at an end of a removed segment that stand before the wall, at the height
/// of the next return beside that end: floor or ceiling, met just before they meet the wall.
void keepFloorAtTheFoot(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                        std::span<const SegmentMatch> matches, std::span<PointLabel> labels);

}  // namespace offmap::core
