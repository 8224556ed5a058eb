// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/SharedOptions.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace offmap::app {

/// The command line of `offmap reduce`.
struct ReduceOptions {
    std::vector<std::filesystem::path> inputs;
    std::filesystem::path output;  ///< a folder, if there are several logs
    std::filesystem::path removed, report, segments,
        inspect;  ///< folders where it is; may be empty
    SharedOptions shared;
    std::vector<std::string> sensors;
    std::string outputClass = "same";       ///< or "points"
    std::optional<std::string> writePoses;  ///< label of refined poses; none: not written
    int compression = 1;                    ///< gzip level, 0 to 9
    size_t threads = 0;                     ///< 0: as many as there are processors
    bool strict = false, keepGoing = false, force = false, quiet = false;

    void addTo(CLI::App& command);
    size_t threadCount() const;
};

}  // namespace offmap::app
