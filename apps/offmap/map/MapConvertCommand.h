// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace offmap::app {

/// Adds `convert` to `offmap map`. \param exitCode is set when the command has run
void addMapConvertCommand(CLI::App& mapCommand, int& exitCode);

}  // namespace offmap::app
