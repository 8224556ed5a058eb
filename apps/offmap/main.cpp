// SPDX-License-Identifier: BSD-3-Clause
#include "InfoCommand.h"
#include "ReduceCommand.h"
#include "RenderCommand.h"
#include "ScoreCommand.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/UsageError.h"
#include "live/LiveCommand.h"
#include "map/MapCommand.h"
#include "simulate/SimulateCommand.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <vector>

namespace {

/// What is wrong with the command line, and where help is to be had.
std::string usageMessage(const CLI::App* app, const CLI::Error& error) {
    std::string command = "offmap";
    while (!app->get_subcommands().empty()) {
        app = app->get_subcommands().front();
        command += " " + app->get_name();
    }
    if (app->get_require_subcommand_min() == 0) {
        return fmt::format("offmap: {}; {} --help tells what it takes\n", error.what(), command);
    }
    const std::vector<std::string> unknown = app->remaining();
    if (unknown.empty()) {
        return fmt::format("offmap: a subcommand is needed; {} --help lists them\n", command);
    }
    return fmt::format("offmap: there is no {} '{}'; {} --help lists them\n",
                       unknown[0].starts_with('-') ? "option" : "subcommand", unknown[0], command);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace offmap::app;
    prepareStandardStreams();
    CLI::App app("offmap takes out of a 3D laser scan what a 2D map already knows.", "offmap");
    app.set_version_flag("--version", "offmap " OFFMAP_VERSION);
    app.require_subcommand(1);
    app.failure_message(usageMessage);
    int exitCode = exitDone;
    addReduceCommand(app, exitCode);
    addRenderCommand(app, exitCode);
    addInfoCommand(app, exitCode);
    addScoreCommand(app, exitCode);
    addLiveCommand(app, exitCode);
    addSimulateCommand(app, exitCode);
    addMapCommand(app, exitCode);
    return reportingErrors([&] {
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return static_cast<int>(app.exit(error) == 0 ? exitDone : exitUsage);
        }
        return exitCode;
    });
}
