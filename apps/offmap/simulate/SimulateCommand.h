// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace offmap::app {

/// Adds `offmap simulate`. \param exitCode is set when the command has run
void addSimulateCommand(CLI::App& app, int& exitCode);

}  // namespace offmap::app
