// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"
#include "InfoCommand.h"
#include "LiveProgram.h"
#include "ReduceCommand.h"
#include "RenderCommand.h"
#include "ScoreCommand.h"
#include "map/MapCommand.h"
#include "simulate/SimulateCommand.h"

#include <string_view>

namespace offmap::app {
namespace {

void addCommands(CLI::App& app, int& exitCode) {
    app.set_version_flag("--version", "offmap " OFFMAP_VERSION);
    app.require_subcommand(1);
    addReduceCommand(app, exitCode);
    addRenderCommand(app, exitCode);
    addInfoCommand(app, exitCode);
    addScoreCommand(app, exitCode);
    app.add_subcommand("live", liveDescription);
    addSimulateCommand(app, exitCode);
    addMapCommand(app, exitCode);
}

}  // namespace
}  // namespace offmap::app

int main(int argc, char** argv) {
    using namespace offmap::app;
    if (argc > 1 && std::string_view(argv[1]) == "live") {
        argv[1] = argv[0];  // what messages begin with
        return becomeLiveProgram(argv + 1);
    }
    const char* description = "offmap takes out of a 3D laser scan what a 2D map already knows.";
    return runCommandLine(argc, argv, "offmap", description, addCommands);
}
