// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/SharedOptions.h"
#include "input/SourceOptions.h"

#include <filesystem>
#include <optional>
#include <string>

namespace offmap::app {

/// The command line of `offmap live`.
struct LiveCommandOptions {
    SourceOptions from;
    SharedOptions shared;
    size_t waiting = 2;             ///< turns
    std::optional<double> seconds;  ///< [s] after which it ends
    std::filesystem::path record;   ///< may be empty
    bool force = false, quiet = false;

    void addTo(CLI::App& command);
};

}  // namespace offmap::app
