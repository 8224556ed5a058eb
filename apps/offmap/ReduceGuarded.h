// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceJob.h"

#include <offmap/rawlog/GuardedRun.h>

#include <optional>
#include <string>

namespace offmap::app {

/// What became of a log: it was reduced, or failed, or was interrupted.
struct LogOutcome {
    int exitCode = 0;
    std::optional<ReducedLog> reduced;  ///< if its outputs are there
    std::string error;                  ///< why they are not; empty if it was interrupted
    rawlog::GuardedOutcome guarded;
};

/// Reduces a log in a child of this program, which survives what a corrupt log does to its reader.
/// With --keep-going, what cannot be read ends the log.
LogOutcome reduceGuarded(const ReduceJob& job, const LogToReduce& log);

}  // namespace offmap::app
