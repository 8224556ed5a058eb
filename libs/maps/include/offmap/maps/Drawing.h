// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// What a map file holds, in metres: every reader makes one. MapFile.h makes a map of it.
struct Drawing {
    std::string format;                 ///< "text", "DXF", "ROS grid"
    std::vector<std::string> layers;    ///< names; a file without layers has one, of an empty name
    std::vector<core::Wall> walls;      ///< lines and arcs; sigma and height as the file says
    std::vector<uint32_t> layerOf;      ///< of each wall, index into layers
    bool isDrawnByHand = false;         ///< may hold double lines, dashes, specks: to be cleaned
    std::vector<std::string> notes;     ///< what was assumed, as "unit: inches, from $INSUNITS"
    std::vector<std::string> warnings;  ///< what smells, with its fix

    /// The index of a layer, which is added if there is none of that name.
    uint32_t layer(std::string_view name);

    void add(const core::Wall& wall, uint32_t layer) {
        walls.push_back(wall);
        layerOf.push_back(layer);
    }
};

}  // namespace offmap::maps
