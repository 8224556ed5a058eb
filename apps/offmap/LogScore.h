// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/Score.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/GuardedRun.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace offmap::app {

/// What is in one of two files only: how many observations, and which is the first.
struct Unmatched {
    uint64_t observations = 0;
    uint64_t points = 0;
    std::string first;  ///< "'LIDAR' at 1700000000.2500000 s"
};

/// A reduced log judged by the truth of the log that it was made of.
struct LogScore {
    evaluation::PooledScore score;
    uint64_t observations = 0;  ///< that were compared
    Unmatched missing;          ///< of the truth, not in the log
    Unmatched unknown;          ///< of the log, not in the truth
    Unmatched foreign;          ///< in both; of their points, those that are in the log only
    std::string cannotBeRead;   ///< why a 3D observation of the log has no points, if so
};

/// Both files are read once, the log before that once for its times and labels.
/// \throw std::runtime_error if one of them cannot be read, or they differ in order
LogScore scoreLog(const std::filesystem::path& truth, const std::filesystem::path& log,
                  const rawlog::Config& config, rawlog::GuardedStatus& status);

}  // namespace offmap::app
