// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoFacts.h"

#include <string>
#include <vector>

namespace offmap::app {

/// One thing to do, and the words on the command line that do it.
struct AdviceStep {
    std::string what;                ///< a sentence without its full stop
    std::vector<std::string> words;  ///< {"--map", "MAP"}; may be empty
};

/// What a log lacks to be reduced, and the command that reduces it.
struct Advice {
    bool hasScans = false;             ///< 3D scans that can be reduced, perhaps with an option
    std::vector<AdviceStep> missing;   ///< without these, reduction does nothing
    std::vector<AdviceStep> hints;     ///< with these it does better
    std::vector<std::string> command;  ///< empty if there is nothing to reduce
    std::vector<std::string> placeholders;  ///< in the command: what only the user can know
};

/// \param config as the options made it
Advice adviceFor(const LogFacts& facts, const InfoOptions& options, const rawlog::Config& config);

/// The preset in config/ for a sensor, by the name that sensorModelOf() gives it; empty: none.
std::string presetFor(const std::string& modelName);

}  // namespace offmap::app
