// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace offmap::app {

/// Adds `offmap map check`. \param exitCode is set when it has run
void addMapCheckCommand(CLI::App& mapCommand, int& exitCode);

}  // namespace offmap::app
