// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>

#include <cstdint>
#include <filesystem>
#include <functional>

namespace offmap::window {

/// How many turns a log holds, as a replay counts them. Where scanners in a plane are turned, or
/// some scans of a sensor cannot be reduced, the log is read once more to find out.
/// \param onEntry called before an entry is read; what it throws ends the reading
uint64_t turnsIn(const std::filesystem::path& log, const rawlog::LogSurvey& survey,
                 const rawlog::Config& config, const std::function<void()>& onEntry);

}  // namespace offmap::window
