// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SharedOptions.h"

#include <filesystem>
#include <string>
#include <vector>

namespace offmap::app {

/// The command line of `offmap reduce`.
struct ReduceOptions {
    std::filesystem::path input, output, removed, report;  ///< the latter two may be empty
    SharedOptions shared;
    std::vector<std::string> sensors;
    std::string outputClass = "same";  ///< or "points"
    bool strict = false, keepGoing = false, force = false, quiet = false;

    void addTo(CLI::App& command);
    /// \throw UsageError if two of the files are the same
    void checkFiles() const;
};

}  // namespace offmap::app
