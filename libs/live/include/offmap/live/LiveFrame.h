// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionResult.h>
#include <offmap/live/ScanSource.h>
#include <offmap/rawlog/TurnReducer.h>

#include <memory>

namespace offmap::live {

/// A turn and what it was reduced to. Never changes, so any thread may look at it.
struct LiveFrame {
    ArrivedTurn arrived;
    rawlog::ReducedTurn reduced;
    core::ReductionResult result;
    double latency = 0;  ///< [ms] from the arrival of the turn to its result
};

using LiveFramePtr = std::shared_ptr<const LiveFrame>;

}  // namespace offmap::live
