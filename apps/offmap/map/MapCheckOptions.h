// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/SharedOptions.h"

#include <offmap/evaluation/PlanCheck.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <vector>

namespace offmap::app {

/// The command line of `offmap map check`.
struct MapCheckOptions {
    std::vector<std::filesystem::path> logs;
    std::filesystem::path output, profile, picture;  ///< the latter two may be empty
    SharedOptions shared;
    evaluation::PlanCheckConfig check;
    bool json = false, force = false;

    void addTo(CLI::App& command);

    /// \throw UsageError if two files are the same, or one of a wrong kind
    void requireFiles() const;
};

}  // namespace offmap::app
