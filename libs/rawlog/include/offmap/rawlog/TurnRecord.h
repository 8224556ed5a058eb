// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Health.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/rawlog/ScanClass.h>

#include <mrpt/core/Clock.h>

#include <array>
#include <cstdint>
#include <string>

namespace offmap::rawlog {

/// What became of one turn, in figures.
struct TurnRecord {
    uint64_t entry = 0;               ///< of the rawlog, where the turn begins, from 0
    mrpt::Clock::time_point time{};   ///< of its first observation
    std::string label, className;     ///< of its observations
    uint32_t columns = 0;             ///< that hold returns
    uint32_t columnsWithoutPose = 0;  ///< of those; their points are kept
    ReturnCounts counts;
    uint64_t onVerticalSegments = 0;                             ///< points
    uint64_t removedByRay = 0;                                   ///< points
    uint64_t removedByExtension = 0;                             ///< points
    uint64_t removedAsOrphans = 0;                               ///< points
    uint64_t removedByPoint = 0;                                 ///< points; their segment was not
    uint64_t keptOffWall = 0;                                    ///< points; their segment was not
    std::array<uint64_t, core::keepReasonCount> keptByReason{};  ///< points on kept segments
    core::Health health;
    std::string notReduced;   ///< why the whole turn was kept; empty if it was not
    double milliseconds = 0;  ///< [ms] of work, from observation in memory to reduced one in memory

    uint64_t removed() const {
        return removedByRay + removedByExtension + removedAsOrphans + removedByPoint;
    }
};

/// Visits the counts that the figures of a turn and of a whole log have in common, with their key
/// in a report: visit(key, count of the first figures, count of the second, ...).
template <class Visit, class... Figures>
void forEachCount(const Visit& visit, Figures&... figures) {
    visit("points", figures.counts.returns...);
    visit("points_on_vertical_segments", figures.onVerticalSegments...);
    visit("points_removed_by_ray", figures.removedByRay...);
    visit("points_removed_by_extension", figures.removedByExtension...);
    visit("points_removed_as_orphans", figures.removedAsOrphans...);
    visit("points_removed_by_point", figures.removedByPoint...);
    visit("points_kept_off_wall", figures.keptOffWall...);
    visit("slots_without_return", figures.counts.zero...);
    visit("points_not_finite", figures.counts.nonFinite...);
    visit("points_duplicate", figures.counts.duplicates...);
    visit("points_of_robot", figures.counts.self...);
    visit("columns", figures.columns...);
    visit("columns_without_pose", figures.columnsWithoutPose...);
}

}  // namespace offmap::rawlog
