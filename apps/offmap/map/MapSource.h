// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../ConfigOptions.h"
#include "../MapFileOptions.h"

#include <offmap/maps/MapFile.h>
#include <offmap/rawlog/GuardedRun.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>

namespace offmap::app {

/// The map that a subcommand of `offmap map` works on.
struct MapSource {
    std::filesystem::path file;
    MapFileOptions reading;
    ConfigOptions config;

    void addTo(CLI::App& command);

    /// \throw UsageError for a wrong option or configuration
    maps::MapOptions request() const;
};

/// Works on the map in a child of this program, which survives what a corrupt file does to its
/// reader. \return the exit code
int workOnMap(const MapSource& source,
              const std::function<int(const maps::MapOfFile&, rawlog::GuardedStatus&)>& work);

}  // namespace offmap::app
