// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LiveCommandOptions.h"

#include <offmap/live/ScanSource.h>
#include <offmap/live/TrackedPoses.h>
#include <offmap/rawlog/LogSurvey.h>

#include <memory>
#include <string>

namespace offmap::app {

/// Where scans and poses come from.
struct LiveInput {
    std::unique_ptr<live::ScanSource> source;
    std::shared_ptr<const rawlog::PoseSource> poses;
    std::shared_ptr<live::TrackedPoses> tracked;      ///< the same, if they are; else null
    std::shared_ptr<const rawlog::LogSurvey> survey;  ///< that the source refers to; may be null
    std::string description, posesDescription;
    std::string warning;  ///< empty: nothing to warn of
};

/// \throw UsageError, std::runtime_error for what cannot be opened
LiveInput openLiveInput(const LiveCommandOptions& options, const rawlog::Config& config);

}  // namespace offmap::app
