// SPDX-License-Identifier: BSD-3-Clause
#include "MapCommand.h"

#include "MapCheckCommand.h"
#include "MapConvertCommand.h"
#include "MapDrawCommand.h"
#include "MapFromLogCommand.h"
#include "MapInfoCommand.h"

namespace offmap::app {

void addMapCommand(CLI::App& app, int& exitCode) {
    CLI::App& command = *app.add_subcommand("map", "Look at a map, write it in another format");
    command.require_subcommand(1);
    addMapInfoCommand(command, exitCode);
    addMapConvertCommand(command, exitCode);
    addMapDrawCommand(command, exitCode);
    addMapCheckCommand(command, exitCode);
    addMapFromLogCommand(command, exitCode);
}

}  // namespace offmap::app
