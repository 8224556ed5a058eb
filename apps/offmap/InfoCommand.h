// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace offmap::app {

/// Adds `offmap info`. \param exitCode is set when the command has run
void addInfoCommand(CLI::App& app, int& exitCode);

}  // namespace offmap::app
