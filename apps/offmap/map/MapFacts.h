// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/MapFile.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace offmap::app {

/// What there is to tell of a map.
struct MapFacts {
    std::filesystem::path file;
    maps::MapOfFile map;
    mrpt::math::TPoint2D low, high;  ///< [m] corners of the rectangle around all walls
    size_t straight = 0, arcs = 0;
    double length = 0;                                   ///< [m] of all walls
    double shortest = 0, medianLength = 0, longest = 0;  ///< [m]
    double leastSigma = 0, largestSigma = 0;             ///< [m]
    size_t bounded = 0;                                  ///< walls of limited height
    std::optional<double> lowest, highest;               ///< [m] z that any of these has
    std::vector<std::string> warnings;                   ///< of its reader, and what smells besides
};

MapFacts factsOf(maps::MapOfFile map, const std::filesystem::path& file);

/// As a person reads them.
std::string mapInfoText(const MapFacts& facts);
/// As a program does; doc/formats.md tells what the keys mean.
std::string mapInfoJson(const MapFacts& facts);

}  // namespace offmap::app
