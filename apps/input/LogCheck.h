// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>

#include <filesystem>

namespace offmap::app {

/// Reads the log once in a child, which survives what a damaged one does to its reader. A log that
/// ends too early is good as far as it can be read.
/// \throw std::runtime_error saying where, if it cannot be read at all or crashes its reader;
/// Interrupted
void requireReadable(const std::filesystem::path& log, const rawlog::Config& config);

}  // namespace offmap::app
