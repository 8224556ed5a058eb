// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/LogOptions.h"

#include <offmap/rawlog/Config.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace offmap::app {

/// The command line of `offmap map from-log`.
struct MapFromLogOptions : LogOptions {
    std::vector<std::filesystem::path> logs;
    std::filesystem::path output;
    double minLength = 0.5;            ///< [m]
    std::optional<uint32_t> minScans;  ///< none: by the number of scans
    bool force = false;

    void addTo(CLI::App& command);

    /// \throw UsageError for a wrong configuration, file or command line
    rawlog::Config readConfig() const;
};

}  // namespace offmap::app
