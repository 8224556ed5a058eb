// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>
#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace offmap::maps {

/// A layer of a map file.
struct MapLayer {
    std::string name;
    size_t lines = 0;   ///< that the file holds in it
    size_t walls = 0;   ///< that they became; 0 if the layer is left out
    double length = 0;  ///< [m] of these walls
    bool used = true;   ///< whether it was asked for
};

/// The walls of a map file and where they come from.
struct MapOfFile {
    std::string format;             ///< as in Drawing
    std::vector<core::Wall> walls;  ///< never empty
    std::vector<uint32_t> layerOf;  ///< of each wall, index into layers
    std::vector<MapLayer> layers;
    std::vector<std::string> notes, warnings;  ///< as in Drawing
};

/// Reads a map of any kind that doc/formats.md names, by the file's extension; a file of another or
/// no extension is taken for a text map if it is text.
/// \throw std::runtime_error naming the file, the place in it and the fix: if it cannot be read, is
/// of no known kind, or no wall is left of it.
MapOfFile readMap(const std::filesystem::path& file, const MapOptions& options);

/// What readMap() does with what a reader has read: chooses layers, scales, cleans, applies the
/// rules and places. \param name stands for the file in messages
MapOfFile mapOf(Drawing drawing, const MapOptions& options, const std::string& name);

}  // namespace offmap::maps
