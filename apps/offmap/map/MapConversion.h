// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/MapFile.h>
#include <offmap/rawlog/OutputFile.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::app {

/// A map that is to be written.
struct MapConversion {
    const maps::MapOfFile& map;
    std::filesystem::path output;
    double resolution;  ///< [m] of a grid's cell
    rawlog::OutputOptions options;
};

/// What writing a map of a format loses or leaves out, a sentence each.
using ConversionLosses = std::vector<std::string>;

/// A format that maps can be written in.
struct MapWriter {
    std::vector<std::string_view> extensions;  ///< lower case
    void (*write)(const MapConversion& conversion);
    bool keepsSigma, keepsHeight, isGrid;
};

/// By the extension. \throw UsageError listing what can be written
const MapWriter& mapWriterOf(const std::filesystem::path& output);

/// All files that are written besides the one that is named.
std::vector<std::filesystem::path> companionsOf(const std::filesystem::path& output);

/// \param defaultSigma [m] what a wall has that does not tell its own
ConversionLosses lossesOf(const maps::MapOfFile& map, const MapWriter& writer, double defaultSigma);

/// Takes out the walls that are too short to be written. \return how many these were
size_t dropShortest(maps::MapOfFile& map);

}  // namespace offmap::app
