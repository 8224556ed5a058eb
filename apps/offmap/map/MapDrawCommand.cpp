// SPDX-License-Identifier: BSD-3-Clause
#include "MapDrawCommand.h"

#include "MapFigure.h"
#include "MapOutput.h"
#include "input/Console.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <memory>

namespace offmap::app {

namespace {

struct DrawOptions {
    MapSource source;
    MapOutput picture;
    uint32_t size = 1600;  ///< [px] of the longer side

    void addTo(CLI::App& command) {
        source.addTo(command);
        picture.addTo(command, "Picture, a PNG or an SVG by its extension", "F.png|F.svg");
        command.add_option("--size", size, "Pixels of the picture's longer side (1600)")
            ->check(CLI::Range(200, 20'000).description(""))
            ->type_name("PIXELS");
    }
};

int draw(const DrawOptions& options) {
    const std::string kind = options.picture.extension();
    if (kind != ".png" && kind != ".svg") {
        throw UsageError(options.picture.file.string() +
                         ": the picture is a PNG or an SVG; name it so, .png or .svg");
    }
    return writeFromMap(options.source, options.picture,
                        [&](const maps::MapOfFile& map, const rawlog::OutputOptions& output) {
                            rawlog::OutputFile file(options.picture.file, output);
                            view::PlanFigure figure =
                                figureOf(map, options.source.file.filename().string());
                            figure.size = options.size;
                            file.write(kind == ".png" ? view::pngOf(figure) : view::svgOf(figure));
                            file.publish();
                            say(stdout, "wrote   {}\n", options.picture.file.string());
                        });
}

}  // namespace

void addMapDrawCommand(CLI::App& mapCommand, int& exitCode) {
    CLI::App& command =
        *mapCommand.add_subcommand("draw", "Draw a map as a plan with axes and a scale");
    const auto options = std::make_shared<DrawOptions>();
    options->addTo(command);
    command.callback([options, &exitCode] { exitCode = draw(*options); });
}

}  // namespace offmap::app
