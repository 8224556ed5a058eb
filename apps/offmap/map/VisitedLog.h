// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/PoseOptions.h"

#include <offmap/core/LineMap.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/TurnReducer.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace offmap::app {

/// A log that was looked at before its turns are visited.
struct VisitedLog {
    std::filesystem::path file;
    rawlog::LogSurvey survey;
    rawlog::ChosenPoses poses;
    std::vector<std::string> warnings;
};

/// \throw UsageError, std::runtime_error if the log is damaged, holds no 3D scan or has no poses
VisitedLog lookAt(const std::filesystem::path& log, const PoseOptions& poses,
                  const rawlog::Config& config, rawlog::GuardedStatus& status);

/// Reduces every turn of the log. \param visit is called with each, and the reducer that did it
void visitTurns(
    const VisitedLog& log, const core::LineMap& map, const rawlog::Config& config,
    rawlog::GuardedStatus& status,
    const std::function<void(const rawlog::ReducedTurn&, const core::ReductionResult&)>& visit);

}  // namespace offmap::app
