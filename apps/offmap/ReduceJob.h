// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceFiles.h"

#include <offmap/core/LineMap.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/ReductionTotals.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace offmap::app {

/// What all logs of a run are reduced with.
struct ReduceJob {
    const ReduceOptions& options;
    const rawlog::Config& config;
    const core::LineMap& map;
};

/// One of the logs. The title, "2/7 run2.rawlog", is empty for a log by itself.
struct LogToReduce {
    ReduceFiles files;
    std::string title;
};

/// How much of a log there is to read.
struct ReadableLog {
    uint64_t entries =
        std::numeric_limits<uint64_t>::max();  ///< the reading ends before the next one
    std::string endsBecause;                   ///< why, if it is known not to be the end
};

/// What came of a log.
struct ReducedLog {
    rawlog::ReductionTotals totals;
    std::vector<std::string> warnings;
    double seconds = 0;  ///< [s] that it took
};

/// Reduces a log. Reads it twice; outputs appear when all are complete. Tells progress, and of a
/// log by itself what it is reduced with.
/// \throw UsageError, std::exception; then no output has appeared
ReducedLog reduceLog(const ReduceJob& job, const LogToReduce& log, const ReadableLog& readable,
                     rawlog::GuardedStatus& status);

}  // namespace offmap::app
