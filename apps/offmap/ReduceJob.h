// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceOptions.h"

#include <offmap/core/LineMap.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/GuardedRun.h>

#include <cstdint>
#include <limits>
#include <string>

namespace offmap::app {

/// How much of a log there is to read.
struct ReadableLog {
    uint64_t entries =
        std::numeric_limits<uint64_t>::max();  ///< the reading ends before the next one
    std::string endsBecause;                   ///< why, if it is known not to be the end
};

/// Reduces a log and prints what came of it. Reads it twice; outputs appear when all are complete.
/// \return exitDone or exitNotReduced
/// \throw UsageError, std::exception; then no output has appeared
int reduceLog(const ReduceOptions& options, const rawlog::Config& config, const core::LineMap& map,
              const ReadableLog& readable, rawlog::GuardedStatus& status);

}  // namespace offmap::app
