// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/maps/MapFile.h>

#include <filesystem>
#include <string>
#include <vector>

namespace offmap::app {

/// A map that is ready to be used, and what there is to tell of it.
struct LoadedMap {
    core::LineMap lines;
    std::string format, description;
    std::vector<std::string> notes, warnings;
};

LoadedMap loadedMapOf(maps::MapOfFile map, const std::string& file);

/// \throw std::runtime_error for a map that cannot be read
LoadedMap loadMap(const std::filesystem::path& file, const maps::MapOptions& options);

/// "plan.dxf: 214 walls, 612.4 m, layer WALLS (2 left out: doors, text)"
std::string describe(const maps::MapOfFile& map, const std::string& file);

/// The line "map" of a summary, and the notes below it.
std::string summaryOf(const LoadedMap& map);

}  // namespace offmap::app
