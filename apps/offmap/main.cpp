// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"
#include "Guarded.h"
#include "ReduceCommand.h"
#include "RenderCommand.h"
#include "UsageError.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace {

/// CLI11 says that a subcommand is missing, but not that the word given is none.
void checkSubcommand(const CLI::App& app) {
    const std::vector<std::string> unknown = app.remaining();
    if (!app.get_subcommands().empty() || unknown.empty() || unknown[0].starts_with('-')) return;
    throw offmap::app::UsageError("there is no subcommand '" + unknown[0] +
                                  "'; offmap --help lists them");
}

}  // namespace

int main(int argc, char** argv) {
    using namespace offmap::app;
    prepareStandardStreams();
    CLI::App app("offmap takes out of a 3D laser scan what a 2D map already knows.", "offmap");
    app.set_version_flag("--version", "offmap " OFFMAP_VERSION);
    app.require_subcommand(1);
    int exitCode = exitDone;
    addReduceCommand(app, exitCode);
    addRenderCommand(app, exitCode);
    return reportingErrors([&] {
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            checkSubcommand(app);
            return static_cast<int>(app.exit(error) == 0 ? exitDone : exitUsage);
        }
        return exitCode;
    });
}
