// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoPoses.h"
#include "ReadableLog.h"

#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/LogInventory.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace offmap::app {

/// The command line of `offmap info`.
struct InfoOptions {
    std::filesystem::path input;
    SharedOptions shared;              ///< as for reduction; the map may be missing
    std::vector<std::string> sensors;  ///< labels; empty: all
    bool json = false, quiet = false;
    std::vector<std::string> forReduce;  ///< what of the command line reduction takes as well

    void addTo(CLI::App& command);
    /// Fills in forReduce from what was parsed.
    void rememberForReduce(const CLI::App& command);
    /// Whether a sensor is to be reduced.
    bool chooses(const std::string& label) const;
};

/// All that `offmap info` has to tell of a log.
struct LogFacts {
    std::filesystem::path file;
    uint64_t fileBytes = 0;
    uint64_t unpackedBytes = 0;  ///< as far as it could be read
    bool gzip = false;
    std::string damage;                 ///< where the reading ended and why; empty: at the end
    std::vector<std::string> warnings;  ///< settings that can hardly be meant
    std::unique_ptr<rawlog::LogSurvey> survey;
    PoseFacts poses;
    std::unique_ptr<rawlog::LogInventory> inventory;
};

/// Reads the log twice. \param config must outlive what is returned
/// \throw UsageError, std::exception if there is nothing to tell
LogFacts gatherFacts(const InfoOptions& options, const rawlog::Config& config,
                     const ReadableLog& readable, rawlog::GuardedStatus& status);

}  // namespace offmap::app
