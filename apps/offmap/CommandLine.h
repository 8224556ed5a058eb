// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace offmap::app {

/// The `main` of a program: reads the command line and does what it asks for.
/// \param addTo adds what the program takes, with what sets the exit code
int runCommandLine(int argc, char** argv, const std::string& name, const std::string& description,
                   const std::function<void(CLI::App&, int& exitCode)>& addTo);

}  // namespace offmap::app
