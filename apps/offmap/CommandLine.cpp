// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "input/Console.h"
#include "input/Guarded.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <vector>

namespace offmap::app {

namespace {

/// What is wrong with the command line, and where help is to be had.
std::string usageMessage(const CLI::App* app, const CLI::Error& error) {
    std::string command = app->get_name();
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

int runCommandLine(int argc, char** argv, const std::string& name, const std::string& description,
                   const std::function<void(CLI::App&, int&)>& addTo) {
    prepareStandardStreams();
    CLI::App app(description, name);
    app.failure_message(usageMessage);
    int exitCode = exitDone;
    addTo(app, exitCode);
    return reportingErrors([&] {
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return static_cast<int>(app.exit(error) == 0 ? exitDone : exitUsage);
        }
        return exitCode;
    });
}

}  // namespace offmap::app
