// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LoadedMap.h"
#include "LogOptions.h"
#include "MapFileOptions.h"

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/PoseChoice.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace offmap::app {

/// What every subcommand that reduces scans asks for: map, configuration and poses.
struct SharedOptions : LogOptions {
    std::filesystem::path map;
    MapFileOptions mapFile;
    std::string method;

    void addTo(CLI::App& command);

    /// \throw UsageError for a wrong configuration, file or command line
    rawlog::Config readConfig() const;
    /// \throw UsageError for a wrong option of the map, std::runtime_error for one that cannot be
    /// read
    LoadedMap readMap(const rawlog::Config& config) const;
};

/// \throw UsageError if the choice is not clear, std::runtime_error if there is no pose at all
rawlog::ChosenPoses choosePoses(const SharedOptions& options, const rawlog::Config& config,
                                const std::filesystem::path& log, const rawlog::LogSurvey& survey,
                                bool mayBeMissing);

}  // namespace offmap::app
