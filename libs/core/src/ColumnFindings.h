// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LevelledScan.h>
#include <offmap/core/LineMap.h>
#include <offmap/core/MapMatching.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/PoseCorrection.h>
#include <offmap/core/ReductionConfig.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/core/VerticalSegments.h>
#include <offmap/core/WallSight.h>

#include <optional>
#include <vector>

namespace offmap::core {

/// What each column of a scan tells by itself, found as soon as it has been taken.
class ColumnFindings {
 public:
    ColumnFindings(const LineMap& map, const ReductionConfig& config);

    void begin();
    /// The columns behind those that are known. Appends their segments and matches.
    void add(const OrganizedScan& scan, ReductionResult& result);
    /// Why no column can be reduced, if so.
    std::optional<PoseFault> notReduced() const;

    const LevelledScan& levelled() const { return levelled_; }
    /// One per column; none: its pose cannot be used.
    const std::vector<std::optional<Viewpoint>>& viewpoints() const { return viewpoints_; }
    /// Both but for the paper's method: one per column, one per segment that has a viewpoint.
    const std::vector<ColumnPlace>& places() const { return places_; }
    const std::vector<WallSight>& sights() const { return sights_; }

 private:
    void addViewpoint(const OrganizedScan& scan, ReductionResult& result);
    void matchByRays(ReductionResult& result, size_t firstSegment) const;
    void addSights(const OrganizedScan& scan, const ReductionResult& result, size_t firstSegment);

    const LineMap& map_;
    const ReductionConfig& config_;
    double maxMountingSlope_;  // [-]
    VerticalSegmentFinder finder_;
    LevelledScan levelled_;
    std::vector<std::optional<Viewpoint>> viewpoints_;
    std::vector<ColumnPlace> places_;
    std::vector<WallSight> sights_;
    std::optional<PoseFault> firstFault_;
    bool anyUsable_ = false, offMap_ = true;
};

}  // namespace offmap::core
