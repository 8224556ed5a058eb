// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/ConfigOptions.h"
#include "input/MapFileOptions.h"

#include <offmap/maps/MapFile.h>

#include <CLI/CLI.hpp>

#include <filesystem>

namespace offmap::app {

/// The map that a subcommand of `offmap map` works on.
struct MapSource {
    std::filesystem::path file;
    MapFileOptions reading;
    ConfigOptions config;

    void addTo(CLI::App& command);

    /// \throw UsageError for a wrong option or configuration
    maps::MapOptions request() const;
    /// \throw as request() and readMapGuarded()
    maps::MapOfFile read() const;
};

}  // namespace offmap::app
