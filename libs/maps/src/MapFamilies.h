// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// Which of the options mean something to a family of files.
struct UsedOptions {
    bool units = false, coordinates = false, resolution = false, gridWalls = false;
};

/// Map files that are read alike.
struct MapFamily {
    std::string_view name;                     ///< in the plural, for messages
    std::vector<std::string_view> extensions;  ///< lower case, with their dots
    std::function<Drawing(const std::filesystem::path&, const MapOptions&)> read;
    UsedOptions uses;
};

/// By the file's extension; a file of another or no extension is taken for text.
const MapFamily& familyOf(const std::filesystem::path& file);

/// Whether the extension is that of a family, or there is none.
bool isKnownExtension(const std::filesystem::path& file);

/// ".lines, .txt, .dxf, ..."
std::string knownExtensions();

/// What was asked for and means nothing to files of the family, a sentence each.
std::vector<std::string> warningsOfUnused(const MapFamily& family, const MapOptions& options);

}  // namespace offmap::maps
