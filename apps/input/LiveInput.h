// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LogCheck.h"
#include "SharedOptions.h"
#include "SourceOptions.h"

#include <offmap/live/RawlogReplay.h>
#include <offmap/live/ScanSource.h>
#include <offmap/live/TrackedPoses.h>
#include <offmap/rawlog/LogSurvey.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace offmap::app {

/// Where scans and poses come from.
struct LiveInput {
    std::unique_ptr<live::ScanSource> source;
    live::RawlogReplay* replay = nullptr;  ///< the same, if it is one; for its controls
    std::shared_ptr<const rawlog::PoseSource> poses;
    std::shared_ptr<live::TrackedPoses> tracked;      ///< the same, if they are; else null
    std::shared_ptr<const rawlog::LogSurvey> survey;  ///< that the source refers to; may be null
    std::filesystem::path file;                       ///< that the source reads; empty: none
    std::string description, posesDescription;
    std::string warning;  ///< empty: nothing to warn of
};

/// What a user asks to watch.
struct LiveRequest {
    SourceOptions from;
    SharedOptions shared;
    bool forWindow = false;  ///< a log waits at its end, and may be without poses
    /// Called before an entry of a log is read; what it throws ends the opening.
    std::function<void()> onEntry = [] {};
    /// Must throw if reading the log might crash this program.
    std::function<void(const std::filesystem::path&, const rawlog::Config&)> checkLog =
        requireReadable;
};

/// \throw UsageError, std::runtime_error for what cannot be opened
LiveInput openLiveInput(const LiveRequest& request, const rawlog::Config& config);

}  // namespace offmap::app
