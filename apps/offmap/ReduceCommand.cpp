// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceCommand.h"

#include "Guarded.h"
#include "ReduceJob.h"
#include "UsageError.h"

#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/GuardedRun.h>

#include <fmt/format.h>

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
    if (options.keepGoing && outcome.place && outcome.place->index < readable.entries) {
        return reduceGuarded(options, config, map, {outcome.place->index, what});
    }
    fmt::print(stderr, "offmap: {}; --keep-going writes what stands before it\n", what);
    return exitFailed;
}

}  // namespace

void addReduceCommand(CLI::App& app, int& exitCode) {
    CLI::App& command = *app.add_subcommand(
        "reduce", "Take out of the 3D scans of a rawlog what the map already knows");
    const auto options = std::make_shared<ReduceOptions>();
    options->addTo(command);
    command.callback([options, &exitCode] {
        options->checkFiles();
        const rawlog::Config config = options->shared.readConfig();
        const core::LineMap map = options->shared.readMap(config);
        exitCode = reduceGuarded(*options, config, map, {});
    });
}

}  // namespace offmap::app
