// SPDX-License-Identifier: BSD-3-Clause
#include "MapFileOptions.h"

#include "NumberList.h"
#include "UsageError.h"

#include <fmt/format.h>

#include <cmath>

namespace offmap::app {

namespace {

void requirePositive(const std::optional<double>& value, std::string_view option) {
    if (!value || (*value > 0 && std::isfinite(*value))) return;
    throw UsageError(fmt::format("{} is {}, but it has to be above 0", option, *value));
}

maps::GeographicPlace parseAnchor(const std::string& text) {
    const auto numbers = parseNumbers(text, "--map-anchor", "latitude,longitude");
    if (std::abs(numbers[0]) > 90 || std::abs(numbers[1]) > 180) {
        throw UsageError(fmt::format(
            "--map-anchor {}: a latitude is -90 ... 90, a longitude -180 ... 180 degrees", text));
    }
    return {numbers[0], numbers[1]};
}

}  // namespace

void MapFileOptions::addTo(CLI::App& command) {
    command
        .add_option("--map-layer", layers,
                    "Take only this layer of the map, * and ? as in a shell; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command
        .add_option("--map-exclude-layer", excludedLayers,
                    "Leave out this layer of the map; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command.add_option("--map-units", units, "Unit of the drawing, instead of what it says")
        ->check(CLI::IsMember({"m", "cm", "mm", "in", "ft"}).description(""))
        ->type_name("m|cm|mm|in|ft");
    command
        .add_option("--map-crs", coordinates,
                    "Coordinates are lengths in a plane, whatever the file says")
        ->check(CLI::IsMember({"local"}).description(""))
        ->type_name("local");
    command
        .add_option("--map-anchor", anchor,
                    "Where on the earth a geographic map becomes 0,0 (its middle)")
        ->type_name("LAT,LON")
        ->check(notEmpty);
    command.add_option("--map-scale", scale, "Factor of the map's lengths")->type_name("FACTOR");
    command
        .add_option("--map-origin", origin,
                    "Where the map's origin stands in the frame of the poses")
        ->type_name("X,Y,YAW_DEG")
        ->check(notEmpty);
    command.add_option("--map-resolution", resolution, "Size of a pixel of a map picture")
        ->type_name("METRES");
    command
        .add_option("--map-as", walls, "Walls of a grid: straight lines, or the faces of its cells")
        ->check(CLI::IsMember({"lines", "grid"}).description(""))
        ->type_name("lines|grid");
}

maps::MapOptions MapFileOptions::request(const rawlog::Config& config) const {
    maps::MapOptions request;
    request.sigma = config.map.sigma;
    request.minLength = config.map.minLength;
    for (const rawlog::LayerConfig& layer : config.map.layers) {
        request.rules.push_back({layer.layer, layer.sigma, layer.zMin, layer.zMax, layer.present});
    }
    request.layers = layers;
    request.excludedLayers = excludedLayers;
    if (!units.empty()) request.units = maps::lengthUnitOf(units);
    if (!coordinates.empty()) request.coordinates = maps::MapCoordinates::Local;
    if (!anchor.empty()) request.anchor = parseAnchor(anchor);
    if (walls == "grid") request.gridWalls = maps::GridWalls::Cells;
    requirePositive(scale, "--map-scale");
    requirePositive(resolution, "--map-resolution");
    request.scale = scale.value_or(1);
    request.resolution = resolution;
    if (!origin.empty()) request.origin = mrpt::poses::CPose2D(parsePose(origin, "--map-origin"));
    return request;
}

}  // namespace offmap::app
