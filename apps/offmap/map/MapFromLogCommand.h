// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace offmap::app {

/// Adds `offmap map from-log`. \param exitCode is set when it has run
void addMapFromLogCommand(CLI::App& mapCommand, int& exitCode);

}  // namespace offmap::app
