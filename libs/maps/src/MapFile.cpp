// SPDX-License-Identifier: BSD-3-Clause
#include "MapFamilies.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/LayerChoice.h>
#include <offmap/maps/LineCleaning.h>
#include <offmap/maps/MapFile.h>
#include <offmap/maps/WallPlacement.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace offmap::maps {

namespace {

core::Wall ruled(core::Wall wall, const LayerRule* rule) {
    if (rule == nullptr) return wall;
    wall.sigma = rule->sigma.value_or(wall.sigma);
    const double low = rule->zMin.value_or(wall.height.min());
    const double high = rule->zMax.value_or(wall.height.max());
    if (low > high) {
        throw std::runtime_error(fmt::format(
            "the configuration's layers.{} makes walls from z {} up to {}, as the map states the "
            "other one; set both z_min_m and z_max_m",
            rule->layer, low, high));
    }
    wall.height = {low, high};
    return wall;
}

/// The walls of the layers that are used, with what the rules say of these.
void takeWalls(const Drawing& drawing, const MapOptions& options, MapOfFile& map) {
    for (size_t i = 0; i < drawing.walls.size(); ++i) {
        MapLayer& layer = map.layers[drawing.layerOf[i]];
        ++layer.lines;
        if (!layer.used) continue;
        map.walls.push_back(ruled(drawing.walls[i], ruleOf(layer.name, options.rules)));
        map.layerOf.push_back(drawing.layerOf[i]);
    }
}

void requireFinite(const std::vector<core::Wall>& walls, const std::string& name) {
    for (const core::Wall& wall : walls) {
        const auto& [a, b] = wall.line;
        if (std::isfinite(a.x + a.y + b.x + b.y) && std::isfinite(wall.line.length())) continue;
        throw std::runtime_error(fmt::format(
            "{}: a line from ({:g}, {:g}) to ({:g}, {:g}) is none; check scale and unit", name, a.x,
            a.y, b.x, b.y));
    }
}

/// Layer by layer.
void clean(MapOfFile& map, double minLength, const std::string& name) {
    std::vector<std::vector<core::Wall>> ofLayer(map.layers.size());
    for (size_t i = 0; i < map.walls.size(); ++i) ofLayer[map.layerOf[i]].push_back(map.walls[i]);
    map.walls.clear();
    map.layerOf.clear();
    size_t merged = 0, tooShort = 0;
    for (uint32_t layer = 0; layer < ofLayer.size(); ++layer) {
        const CleanedWalls cleanWalls = cleaned(ofLayer[layer], minLength);
        map.walls.insert(map.walls.end(), cleanWalls.walls.begin(), cleanWalls.walls.end());
        map.layerOf.resize(map.walls.size(), layer);
        merged += cleanWalls.merged;
        tooShort += cleanWalls.tooShort;
    }
    if (merged > 0) {
        map.notes.push_back(fmt::format("merged {} duplicate, overlapping or touching line{}",
                                        merged, merged == 1 ? "" : "s"));
    }
    if (tooShort == 0) return;
    map.notes.push_back(fmt::format("dropped {} line{} shorter than {:g} m (map.min_length_m)",
                                    tooShort, tooShort == 1 ? "" : "s", minLength));
    if (map.walls.empty()) {
        throw std::runtime_error(fmt::format(
            "{}: all of its {} lines are shorter than map.min_length_m, {:g} m; a plan on paper? "
            "Give its scale, as --map-scale 100 for 1:100, or its unit, as --map-units m",
            name, tooShort, minLength));
    }
}

void countWalls(MapOfFile& map) {
    for (size_t i = 0; i < map.walls.size(); ++i) {
        MapLayer& layer = map.layers[map.layerOf[i]];
        ++layer.walls;
        layer.length += core::lengthOf(map.walls[i]);
    }
}

}  // namespace

MapOfFile mapOf(Drawing drawing, const MapOptions& options, const std::string& name) {
    const std::vector<bool> used = chooseLayers(drawing, options, name);
    MapOfFile map;
    map.format = drawing.format;
    map.notes = std::move(drawing.notes);
    map.warnings = std::move(drawing.warnings);
    for (auto& warning : warningsOfRules(drawing, options.rules)) {
        map.warnings.push_back(std::move(warning));
    }
    for (size_t i = 0; i < drawing.layers.size(); ++i) {
        map.layers.push_back({.name = drawing.layers[i], .used = used[i]});
    }
    takeWalls(drawing, options, map);
    map.walls = placed(std::move(map.walls), options.origin, options.scale);
    if (map.walls.empty()) {
        throw std::runtime_error(fmt::format(
            "{}: the map holds no wall: there is no line in it that could be one", name));
    }
    requireFinite(map.walls, name);
    if (drawing.isDrawnByHand) clean(map, options.minLength, name);
    countWalls(map);
    return map;
}

MapOfFile readMap(const std::filesystem::path& file, const MapOptions& options) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
        throw std::runtime_error(file.string() + ": is a folder; name a map file in it");
    }
    const MapFamily& family = familyOf(file);
    try {
        Drawing drawing = family.read(file, options);
        for (const std::string& warning : warningsOfUnused(family, options)) {
            drawing.warnings.push_back(warning);
        }
        return mapOf(std::move(drawing), options, file.string());
    } catch (const std::runtime_error& error) {
        if (isKnownExtension(file) || !std::filesystem::exists(file, ignored)) throw;
        throw std::runtime_error(fmt::format("{}; or is it no text map? Others are known by {}",
                                             error.what(), knownExtensions()));
    }
}

}  // namespace offmap::maps
