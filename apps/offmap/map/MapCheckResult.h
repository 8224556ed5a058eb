// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/evaluation/PlanCheck.h>
#include <offmap/maps/MapFile.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <string>
#include <vector>

namespace offmap::app {

/// What a plan check has found out.
struct MapCheckResult {
    std::string mapName, mapText;  ///< of the file, and describe()
    maps::MapOfFile file;          ///< its walls, with their layers
    std::vector<evaluation::WallCheck> walls;
    uint64_t logs = 0, scans = 0;
    uint64_t notUsed = 0;        ///< scans without poses that can be used, or that do not fit
    mrpt::math::TPoint2D shift;  ///< [m] mean correction of the poses
    std::vector<mrpt::math::TPoint2D>
        seen;  ///< [m] places of what is off the walls, one each few cm
    std::vector<std::string> warnings;

    const std::string& layerOf(const evaluation::WallCheck& check) const {
        return file.layers[file.layerOf[check.wall]].name;
    }
};

/// What became of a wall as a whole: seen if any of it is.
evaluation::BinState stateOf(const evaluation::WallCheck& check);

/// One line per wall.
std::string wallsCsv(const MapCheckResult& result);
/// One line per bin of each wall.
std::string profileCsv(const MapCheckResult& result);

/// What stands on the terminal.
std::string summaryText(const MapCheckResult& result);
/// The same and all walls, for programs.
std::string checkJson(const MapCheckResult& result);

/// The walls coloured by how far they are off, their profile beside them. PNG or SVG by extension.
std::string checkPicture(const MapCheckResult& result, const std::string& extension);

}  // namespace offmap::app
