// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReadableLog.h"
#include "ReduceFiles.h"

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/ReductionTotals.h>

#include <string>
#include <vector>

namespace offmap::app {

/// What all logs of a run are reduced with.
struct ReduceJob {
    const ReduceOptions& options;
    const rawlog::Config& config;
    const LoadedMap& map;
};

/// One of the logs. The title, "2/7 run2.rawlog", is empty for a log by itself.
struct LogToReduce {
    ReduceFiles files;
    std::string title;
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
