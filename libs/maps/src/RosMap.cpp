// SPDX-License-Identifier: BSD-3-Clause
#include "FileBytes.h"
#include "Picture.h"

#include <offmap/maps/GridDrawing.h>
#include <offmap/maps/RosMap.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace offmap::maps {

namespace {

/// map_server's reading of a pixel: black is occupied, unless negated.
CellOfBrightness meaningOf(const RosMapDescription& map) {
    const double occupied = map.occupied, free = map.free;
    if (map.mode == RosMapMode::Raw) {
        return [=](double brightness) {
            const double percent = std::round(255 * brightness);
            if (percent > 100) return Cell::Unknown;
            return percent > 100 * occupied ? Cell::Occupied
                   : percent < 100 * free   ? Cell::Free
                                            : Cell::Unknown;
        };
    }
    return [=, negate = map.negate](double brightness) {
        const double chance = negate ? brightness : 1 - brightness;
        return chance > occupied ? Cell::Occupied : chance < free ? Cell::Free : Cell::Unknown;
    };
}

PictureGrid readImage(const RosMapDescription& map, const std::filesystem::path& file) {
    // A path that is absolute replaces the folder.
    const std::filesystem::path image = file.parent_path() / map.image;
    try {
        return readPicture(image, map.resolution, meaningOf(map));
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: its image: {}", file.string(), error.what()));
    }
}

}  // namespace

Drawing readRosMap(const std::filesystem::path& file, const MapOptions& options) {
    constexpr size_t mostBytes = 100'000;
    const RosMapDescription map = parseRosMap(bytesOf(file, mostBytes), file.string());
    PictureGrid picture = readImage(map, file);
    picture.grid.origin = map.origin;
    Drawing drawing = drawingOf(std::move(picture.grid), options, "ROS map", file.string());
    warnOfUnusedOptions(options, drawing);
    for (const auto& warnings : {map.warnings, picture.warnings}) {
        drawing.warnings.insert(drawing.warnings.end(), warnings.begin(), warnings.end());
    }
    return drawing;
}

}  // namespace offmap::maps
