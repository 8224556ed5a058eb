// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceCommand.h"

#include "Console.h"
#include "Guarded.h"
#include "ReduceJob.h"
#include "UsageError.h"

#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/GuardedRun.h>

#include <memory>

namespace offmap::app {

namespace {

int reduceGuarded(const ReduceOptions& options, const rawlog::Config& config,
                  const core::LineMap& map, const ReadableLog& readable) {
    using Kind = rawlog::GuardedOutcome::Kind;
    const rawlog::GuardedOutcome outcome =
        reportingErrorsGuarded([&](rawlog::GuardedStatus& status) {
            return reduceLog(options, config, map, readable, status);
        });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    const std::string what = rawlog::unreadableEntry(
        options.input, outcome.place.value_or(rawlog::EntryPlace{}), outcome.cause);
    const uint64_t readableEntries = outcome.place ? outcome.place->index : 0;
    if (options.keepGoing && readableEntries > 0 && readableEntries < readable.entries) {
        return reduceGuarded(options, config, map, {readableEntries, what});
    }
    const bool keepGoingHelps = !options.keepGoing && readableEntries > 0;
    say(stderr, "offmap: {}{}\n", what,
        keepGoingHelps ? "; --keep-going writes what stands before it" : "");
    return exitFailed;
}

}  // namespace

void addReduceCommand(CLI::App& app, int& exitCode) {
    CLI::App& command = *app.add_subcommand(
        "reduce", "Take out of the 3D scans of a rawlog what the map already knows");
    const auto options = std::make_shared<ReduceOptions>();
    options->addTo(command);
    command.footer(
        "Exit codes: 0 done, 1 usage, 2 input or output failed, 3 with --strict: a scan could not "
        "be reduced");
    command.callback([options, &exitCode] {
        options->checkFiles();
        const rawlog::Config config = options->shared.readConfig();
        const core::LineMap map = options->shared.readMap(config);
        exitCode = reduceGuarded(*options, config, map, {});
    });
}

}  // namespace offmap::app
