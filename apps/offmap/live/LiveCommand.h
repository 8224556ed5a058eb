// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace offmap::app {

/// `offmap live`: reduces what a sensor, a capture or a log delivers, as it comes.
void addLive(CLI::App& command, int& exitCode);

}  // namespace offmap::app
