// SPDX-License-Identifier: BSD-3-Clause
#include "MapConvertCommand.h"

#include "../TextSections.h"
#include "MapConversion.h"
#include "MapOutput.h"
#include "input/Console.h"
#include "input/LoadedMap.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <memory>

namespace offmap::app {

namespace {

struct ConvertOptions {
    MapSource source;
    MapOutput output;
    double resolution = 0.05;  ///< [m]

    void addTo(CLI::App& command) {
        source.addTo(command);
        output.addTo(command,
                     "The map again, in the format of its extension: .lines, .dxf, .geojson, .svg, "
                     ".gridmap, .gridmap.gz, or .yaml (ROS, with its .pgm)",
                     "FILE");
        command.add_option("--resolution", resolution, "Size of a cell of a grid (0.05)")
            ->check(CLI::Range(0.001, 10.0).description(""))
            ->type_name("METRES");
    }
};

/// Losses are told once the file is there: what fails says so in one message.
void write(const ConvertOptions& options, const MapWriter& writer, maps::MapOfFile map,
           const rawlog::OutputOptions& output) {
    ConversionLosses losses = lossesOf(map, writer, options.source.request().sigma);
    const size_t dropped = dropShortest(map);
    if (dropped > 0) {
        losses.push_back(fmt::format("{} of less than 0.2 mm left out", counted(dropped, "wall")));
    }
    if (map.walls.empty()) {
        throw std::runtime_error(options.source.file.string() +
                                 ": all of its walls are shorter than 0.2 mm; --map-units and "
                                 "--map-scale make them longer");
    }
    writer.write({map, options.output.file, options.resolution, output});
    for (const std::string& loss : losses) say(stderr, "warning: {}\n", loss);
    say(stdout, "map     {}\n", describe(map, options.source.file.string()));
    for (const std::string& note : map.notes) say(stdout, "        {}\n", note);
    say(stdout, "wrote   {}\n", options.output.file.string());
    for (const auto& file : options.output.companions) say(stdout, "        {}\n", file.string());
}

int convert(ConvertOptions options) {
    const MapWriter& writer = mapWriterOf(options.output.file);
    options.output.companions = companionsOf(options.output.file);
    return writeFromMap(options.source, options.output,
                        [&](const maps::MapOfFile& map, const rawlog::OutputOptions& output) {
                            write(options, writer, map, output);
                        });
}

}  // namespace

void addMapConvertCommand(CLI::App& mapCommand, int& exitCode) {
    CLI::App& command = *mapCommand.add_subcommand("convert", "Write a map in another format");
    const auto options = std::make_shared<ConvertOptions>();
    options->addTo(command);
    command.footer(
        "Text, GeoJSON and SVG keep all that offmap knows of a wall. DXF knows neither sigma nor\n"
        "height, grids know neither of them nor layers.");
    command.callback([options, &exitCode] { exitCode = convert(*options); });
}

}  // namespace offmap::app
