// SPDX-License-Identifier: BSD-3-Clause
#include "MapInfoCommand.h"

#include "MapFacts.h"
#include "MapSource.h"
#include "input/Console.h"
#include "input/UsageError.h"

#include <memory>

namespace offmap::app {

namespace {

struct MapInfoOptions {
    MapSource source;
    bool json = false;
};

}  // namespace

void addMapInfoCommand(CLI::App& mapCommand, int& exitCode) {
    CLI::App& command = *mapCommand.add_subcommand(
        "info", "Tell what a map holds: extent, walls, layers, units, and what smells");
    const auto options = std::make_shared<MapInfoOptions>();
    options->source.addTo(command);
    command.add_flag("--json", options->json, "The same facts as JSON");
    command.footer(
        "Exit codes: 0 the map can be used, with warnings or without; 1 usage; 2 it cannot");
    command.callback([options, &exitCode] {
        const MapFacts facts = factsOf(options->source.read(), options->source.file);
        say(stdout, "{}", options->json ? mapInfoJson(facts) : mapInfoText(facts));
        exitCode = exitDone;
    });
}

}  // namespace offmap::app
