// SPDX-License-Identifier: BSD-3-Clause
#include "MapConversion.h"

#include "../PlainText.h"
#include "../TextSections.h"
#include "input/UsageError.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/DrawingFile.h>
#include <offmap/maps/GridWriter.h>
#include <offmap/maps/LowerCase.h>
#include <offmap/maps/RosMapWriter.h>
#include <offmap/maps/SvgMapWriter.h>
#include <offmap/maps/TextMapWriter.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace offmap::app {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> layerOfEach(const maps::MapOfFile& map) {
    std::vector<std::string> names;
    for (const uint32_t layer : map.layerOf) names.push_back(map.layers[layer].name);
    return names;
}

void writeFile(const MapConversion& conversion, std::string_view bytes) {
    rawlog::OutputFile file(conversion.output, conversion.options);
    file.write(bytes);
    file.publish();
}

/// "# layer WALLS" above the walls of each layer that has a name.
void writeText(const MapConversion& conversion) {
    const maps::MapOfFile& map = conversion.map;
    std::string text;
    for (size_t i = 0; i < map.walls.size();) {
        const size_t begin = i;
        while (i < map.walls.size() && map.layerOf[i] == map.layerOf[begin]) ++i;
        const std::string piece = maps::textMapOf(std::span(map.walls).subspan(begin, i - begin));
        const std::string& layer = map.layers[map.layerOf[begin]].name;
        const size_t heading = piece.find('\n') + 1;  // the same line above each piece
        if (begin == 0) text = piece.substr(0, heading);
        if (!layer.empty()) text += fmt::format("\n# layer {}\n", printable(layer));
        text += piece.substr(heading);
    }
    writeFile(conversion, text);
}

void writeDxf(const MapConversion& conversion) {
    writeFile(conversion, maps::dxfOf(conversion.map.walls, layerOfEach(conversion.map)));
}

void writeGeoJson(const MapConversion& conversion) {
    writeFile(conversion, maps::geoJsonOf(conversion.map.walls, layerOfEach(conversion.map)));
}

void writeSvg(const MapConversion& conversion) {
    writeFile(conversion, maps::svgMapOf(conversion.map.walls, layerOfEach(conversion.map)));
}

void writeGridMap(const MapConversion& conversion) {
    MapConversion packed = conversion;
    if (conversion.output.extension() == ".gz") packed.options.gzipLevel = 6;
    writeFile(packed,
              maps::gridMapBytes(maps::gridOf(conversion.map.walls, conversion.resolution)));
}

void writeRosMap(const MapConversion& conversion) {
    const maps::OccupancyGrid grid = maps::gridOf(conversion.map.walls, conversion.resolution);
    const fs::path name = companionsOf(conversion.output).front();
    rawlog::OutputFile picture(name, conversion.options);
    rawlog::OutputFile yaml(conversion.output, conversion.options);
    picture.write(maps::rosPictureOf(grid));
    yaml.write(maps::rosYamlOf(grid, name.filename().string()));
    picture.finish();
    yaml.finish();
    picture.publish();
    yaml.publish();  // last: where it is, the picture is
}

const std::vector<MapWriter>& writers() {
    static const std::vector<MapWriter> all{
        {{".lines", ".txt"}, writeText, true, true, false},
        {{".dxf"}, writeDxf, false, false, false},
        {{".geojson", ".json"}, writeGeoJson, true, true, false},
        {{".svg"}, writeSvg, true, true, false},
        {{".gridmap", ".gridmap.gz"}, writeGridMap, false, false, true},
        {{".yaml", ".yml"}, writeRosMap, false, false, true}};
    return all;
}

bool isBounded(const core::Wall& wall) {
    return std::isfinite(wall.height.min()) || std::isfinite(wall.height.max());
}

}  // namespace

const MapWriter& mapWriterOf(const fs::path& output) {
    const std::string name = maps::lowerCase(output.filename().string());
    std::vector<std::string_view> known;
    for (const MapWriter& writer : writers()) {
        for (const std::string_view extension : writer.extensions) {
            if (name.size() > extension.size() && name.ends_with(extension)) return writer;
            known.push_back(extension);
        }
    }
    throw UsageError(fmt::format("OUT {}: no map can be written under that extension; there are {}",
                                 output.string(), fmt::join(known, ", ")));
}

std::vector<fs::path> companionsOf(const fs::path& output) {
    if (mapWriterOf(output).write != writeRosMap) return {};
    return {fs::path(output).replace_extension(".pgm")};
}

ConversionLosses lossesOf(const maps::MapOfFile& map, const MapWriter& writer,
                          double defaultSigma) {
    ConversionLosses losses;
    const std::string format(writer.extensions.front().substr(1));
    const auto count = [&](auto&& isMeant) {
        return static_cast<uint64_t>(std::ranges::count_if(map.walls, isMeant));
    };
    const uint64_t sigmas = count([&](const auto& w) { return w.sigma != defaultSigma; });
    if (!writer.keepsSigma && sigmas > 0) {
        losses.push_back(fmt::format("{} of a sigma of their own lose it: {} has no place for it",
                                     counted(sigmas, "wall"), format));
    }
    const uint64_t bounded = count(isBounded);
    if (!writer.keepsHeight && bounded > 0) {
        losses.push_back(fmt::format("{} of limited height {} it: {} has no place for it",
                                     counted(bounded, "wall"), bounded == 1 ? "loses" : "lose",
                                     format));
    }
    const uint64_t unseen = count([](const auto& w) { return !w.height.contains(1); });
    if (writer.isGrid && unseen > 0) {
        losses.push_back(
            fmt::format("{} left out, which the height of 1 m of the grid does not meet",
                        counted(unseen, "wall")));
    }
    return losses;
}

size_t dropShortest(maps::MapOfFile& map) {
    constexpr double shortest = 2e-4;  // [m] text has ten thousandths of a metre
    size_t kept = 0;
    for (size_t i = 0; i < map.walls.size(); ++i) {
        if (map.walls[i].line.length() < shortest) continue;
        map.walls[kept] = map.walls[i];
        map.layerOf[kept++] = map.layerOf[i];
    }
    const size_t dropped = map.walls.size() - kept;
    map.walls.resize(kept);
    map.layerOf.resize(kept);
    return dropped;
}

}  // namespace offmap::app
