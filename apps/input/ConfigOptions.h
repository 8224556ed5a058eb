// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace offmap::app {

/// Where parameters are set; the same for every subcommand that has any.
struct ConfigOptions {
    std::filesystem::path file;         ///< or a preset's name; empty: not given
    std::vector<std::string> settings;  ///< "key=value"

    void addTo(CLI::App& command);

    /// \throw UsageError for a file, key or value that is wrong
    void applyTo(rawlog::Config& config) const;
};

}  // namespace offmap::app
