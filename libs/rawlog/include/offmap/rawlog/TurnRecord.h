// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
    std::array<uint64_t, core::keepReasonCount> keptByReason{};  ///< points on kept segments
    std::string notReduced;   ///< why the whole turn was kept; empty if it was not
    double milliseconds = 0;  ///< [ms] from observation in memory to reduced observation in memory

    uint64_t removed() const { return removedByRay + removedByExtension + removedAsOrphans; }
};

}  // namespace offmap::rawlog
