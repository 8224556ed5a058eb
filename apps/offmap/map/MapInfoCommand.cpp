// SPDX-License-Identifier: BSD-3-Clause
#include "MapInfoCommand.h"

#include "../Console.h"
#include "../LoadedMap.h"
#include "../UsageError.h"
#include "MapSource.h"

#include <memory>

namespace offmap::app {

void addMapInfoCommand(CLI::App& mapCommand, int& exitCode) {
    CLI::App& command = *mapCommand.add_subcommand("info", "Tell what a map holds");
    const auto source = std::make_shared<MapSource>();
    source->addTo(command);
    command.callback([source, &exitCode] {
        exitCode =
            workOnMap(*source, [&](const maps::MapOfFile& map, rawlog::GuardedStatus& status) {
                static_cast<void>(status);
                say(stdout, "map     {}\n", describe(map, source->file.string()));
                return static_cast<int>(exitDone);
            });
    });
}

}  // namespace offmap::app
