// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/MapOptions.h>
#include <offmap/rawlog/Config.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace offmap::app {

/// How a map file is read; the same for every subcommand that takes one.
struct MapFileOptions {
    std::vector<std::string> layers, excludedLayers;
    std::string units, coordinates, anchor, origin, walls;  ///< as written; empty: not given
    std::optional<double> scale, resolution;

    /// The options beside the one that names the file.
    void addTo(CLI::App& command);

    /// \throw UsageError for what cannot be meant
    maps::MapOptions request(const rawlog::Config& config) const;
};

}  // namespace offmap::app
