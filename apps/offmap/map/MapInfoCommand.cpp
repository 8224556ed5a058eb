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
        say(stdout, "map     {}\n", describe(source->read(), source->file.string()));
        exitCode = exitDone;
    });
}

}  // namespace offmap::app
