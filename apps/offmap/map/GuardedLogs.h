// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/GuardedRun.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace offmap::app {

/// Tells which of the logs is read from now on.
using AtLog = std::function<void(size_t)>;

/// Works on logs in a child of this program, which survives what corrupt ones do to their reader.
/// \return the exit code
int workOnLogs(const std::vector<std::filesystem::path>& logs,
               const std::function<int(rawlog::GuardedStatus&, const AtLog&)>& work);

}  // namespace offmap::app
