// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/LengthUnit.h>

#include <mrpt/poses/CPose2D.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace offmap::maps {

/// A place on the earth, WGS 84. In degrees, as everywhere in maps of that kind.
struct GeographicPlace {
    double latitudeDeg;   ///< [deg] north
    double longitudeDeg;  ///< [deg] east
};

/// What the coordinates of a drawing are.
enum class MapCoordinates : uint8_t {
    AsTheFileSays,
    Local,  ///< lengths in a plane, whatever the file says of a coordinate reference system
};

/// How the occupied cells of a grid become walls.
enum class GridWalls : uint8_t {
    Lines,  ///< straight lines along their faces, within half a cell
    Cells,  ///< the faces themselves: a ray ends where an exact traversal of the grid ends
};

/// What holds for the layers of a name.
struct LayerRule {
    std::string layer;              ///< its name; * and ? stand for anything, case for nothing
    std::optional<double> sigma{};  ///< [m]
    std::optional<double> zMin{}, zMax{};  ///< [m] map frame; without: down, up to everywhere
    bool present = true;                   ///< false: its lines are no walls
};

/// What a map file leaves open, or is told better.
struct MapOptions {
    double sigma = 0.03;                      ///< [m] of walls that state none
    double minLength = 0;                     ///< [m] shorter lines of drawings are no walls
    std::vector<std::string> layers;          ///< only these, with wildcards; empty: all
    std::vector<std::string> excludedLayers;  ///< not these, with wildcards
    std::vector<LayerRule> rules;             ///< the first that fits a layer counts
    std::optional<LengthUnit> units;          ///< instead of what the drawing says
    MapCoordinates coordinates = MapCoordinates::AsTheFileSays;
    std::optional<GeographicPlace> anchor;  ///< becomes (0, 0); none: the middle of the map
    std::optional<double> resolution;       ///< [m] of a picture's pixel
    GridWalls gridWalls = GridWalls::Lines;
    double scale = 1;             ///< of all lengths, after the units
    mrpt::poses::CPose2D origin;  ///< of the map in the frame wanted; after the scale
};

}  // namespace offmap::maps
