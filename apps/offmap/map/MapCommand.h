// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace offmap::app {

/// Adds `offmap map` and its subcommands. \param exitCode is set when one of these has run
void addMapCommand(CLI::App& app, int& exitCode);

}  // namespace offmap::app
