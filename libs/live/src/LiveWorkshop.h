// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TurnInProgress.h"

#include <offmap/live/LiveReduction.h>
#include <offmap/rawlog/SensorConfigs.h>
#include <offmap/rawlog/TurnReducer.h>

namespace offmap::live {

/// A reducer, what it refers to, and the turn that it has begun with.
class LiveWorkshop {
 public:
    /// \throw std::invalid_argument if the configuration is not valid
    explicit LiveWorkshop(LiveSetup setup);

    /// Does what can be done before the turn is complete. Passed over if another piece is missing.
    void take(const TurnPiece& piece);

    /// Of a turn whose pieces were taken, only what is left to do.
    rawlog::ReducedTurn reduce(const rawlog::Turn& turn);

    /// Of the last turn, until the next piece or turn.
    const core::ReductionResult& result() const { return reducer_.result(); }

 private:
    const rawlog::ScanClass* scanClassOf(const rawlog::Turn& turn);

    LiveSetup setup_;
    rawlog::SensorConfigs sensors_;
    rawlog::TurnReducer reducer_;
    TurnInProgress progress_;
};

}  // namespace offmap::live
