// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SimulateOutputs.h"

#include <cstdint>
#include <string>

namespace offmap::app {

/// What the returns of a log truly are, counted.
struct TruthCounts {
    uint64_t returns = 0, mapped = 0, objects = 0;
    uint64_t mappedOnSegments = 0;  ///< on vertical segments
    double duration = 0;            ///< [s] of the log

    void add(const LoggedTurn& turn);
};

/// What was simulated, for a person to read at a glance.
std::string summaryOf(const SimulationPlan& plan, const SimulateOptions& options,
                      const TruthCounts& counts);

/// What was written, and how it is reduced and scored.
std::string nextStepsOf(const SimulatedFiles& files, const SimulateOptions& options);

}  // namespace offmap::app
