// SPDX-License-Identifier: BSD-3-Clause
#include "MapFamilies.h"

#include <offmap/maps/GridFile.h>
#include <offmap/maps/LowerCase.h>
#include <offmap/maps/MapPicture.h>
#include <offmap/maps/RosMap.h>
#include <offmap/maps/SimpleMapFile.h>
#include <offmap/maps/SvgMap.h>
#include <offmap/maps/TextMap.h>
#include <offmap/maps/VectorDrawing.h>
#include <offmap/maps/WallPlacement.h>

#include <fmt/format.h>

#include <stdexcept>

namespace offmap::maps {

namespace {

Drawing readText(const std::filesystem::path& file, const MapOptions& options) {
    Drawing drawing;
    drawing.format = "text";
    const uint32_t layer = drawing.layer("");
    std::vector<core::Wall> walls = readTextMap(file, options.sigma);
    if (options.units) {
        walls = placed(std::move(walls), {}, inMetres(*options.units));
        drawing.notes.push_back(fmt::format("unit: {}, by --map-units", toString(*options.units)));
    }
    for (const core::Wall& wall : walls) drawing.add(wall, layer);
    return drawing;
}

Drawing refuseDwg(const std::filesystem::path& file, const MapOptions&) {
    throw std::runtime_error(file.string() + ": DWG is not read; save the drawing as ASCII DXF");
}

/// Text first: what nothing else fits is read as text.
const std::vector<MapFamily>& families() {
    static const std::vector<MapFamily> all{
        {"text maps", {".lines", ".txt"}, readText, {.units = true}},
        {"drawings", vectorExtensions(), readVectorDrawing, {.units = true, .coordinates = true}},
        {"SVG drawings", {".svg", ".svgz"}, readSvgMap, {.units = true}},
        {"DWG drawings", {".dwg"}, refuseDwg, {.units = true, .coordinates = true}},
        {"grid maps", {".gridmap", ".gridmap.gz"}, readGridMapDrawing, {.gridWalls = true}},
        {"simple maps", {".simplemap", ".simplemap.gz"}, readSimpleMap, {.gridWalls = true}},
        {"ROS maps", {".yaml", ".yml"}, readRosMap, {.gridWalls = true}},
        {"pictures", pictureExtensions(), readMapPicture, {.resolution = true, .gridWalls = true}},
    };
    return all;
}

/// Null if no extension fits.
const MapFamily* find(const std::filesystem::path& file) {
    const std::string name = lowerCase(file.filename().string());
    for (const MapFamily& family : families()) {
        for (const std::string_view extension : family.extensions) {
            if (name.size() > extension.size() && name.ends_with(extension)) return &family;
        }
    }
    return nullptr;
}

}  // namespace

const MapFamily& familyOf(const std::filesystem::path& file) {
    const MapFamily* found = find(file);
    return found ? *found : families().front();
}

bool isKnownExtension(const std::filesystem::path& file) {
    return !file.has_extension() || find(file) != nullptr;
}

std::string knownExtensions() {
    std::string all;
    for (const MapFamily& family : families()) {
        for (const std::string_view extension : family.extensions) {
            all += fmt::format("{}{}", all.empty() ? "" : ", ", extension);
        }
    }
    return all;
}

std::vector<std::string> warningsOfUnused(const MapFamily& family, const MapOptions& options) {
    std::vector<std::string> warnings;
    const auto warn = [&](bool given, bool used, std::string_view option) {
        if (given && !used)
            warnings.push_back(fmt::format("{} means nothing to {}", option, family.name));
    };
    warn(options.units.has_value(), family.uses.units, "--map-units");
    warn(options.coordinates == MapCoordinates::Local, family.uses.coordinates, "--map-crs");
    warn(options.anchor.has_value(), family.uses.coordinates, "--map-anchor");
    warn(options.resolution.has_value(), family.uses.resolution, "--map-resolution");
    warn(options.gridWalls == GridWalls::Cells, family.uses.gridWalls, "--map-as grid");
    return warnings;
}

}  // namespace offmap::maps
