// SPDX-License-Identifier: BSD-3-Clause
#include "Guarded.h"
#include "ReduceCommand.h"
#include "RenderCommand.h"
#include "UsageError.h"

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    using namespace offmap::app;
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
            return static_cast<int>(app.exit(error) == 0 ? exitDone : exitUsage);
        }
        return exitCode;
    });
}
