// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceCommand.h"

#include "ReduceBatch.h"
#include "ReduceGuarded.h"
#include "SummaryText.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/UsageError.h"

#include <memory>

namespace offmap::app {

namespace {

/// \throw UsageError if poses are to be written that the method does not refine
void requireRefinedPoses(const ReduceOptions& options, const rawlog::Config& config) {
    if (!options.writePoses) return;
    if (config.reduction.matching.method == core::MatchingMethod::Aligned) return;
    throw UsageError(
        "--write-poses writes poses that the scans have refined, and only the method aligned does "
        "that: add --method aligned");
}

int reduceAlone(const ReduceJob& job, const ReduceFiles& files) {
    const LogOutcome outcome = reduceGuarded(job, {files, ""});
    if (!outcome.reduced) {
        if (outcome.error.empty()) return exitCodeOfInterruption(outcome.guarded);
        say(stderr, "offmap: {}\n", outcome.error);
        return outcome.exitCode;
    }
    if (!job.options.quiet) {
        say(stdout, "{}wrote   {} ({}, was {})\n",
            summaryOf(outcome.reduced->totals, outcome.reduced->seconds), files.output.string(),
            sizeText(sizeOf(files.output)), sizeText(sizeOf(files.input)));
    }
    for (const std::string& warning : outcome.reduced->warnings) {
        say(stderr, "warning: {}\n", warning);
    }
    return outcome.exitCode;
}

}  // namespace

void addReduceCommand(CLI::App& app, int& exitCode) {
    CLI::App& command = *app.add_subcommand(
        "reduce", "Take out of the 3D scans of rawlogs what the map already knows");
    const auto options = std::make_shared<ReduceOptions>();
    options->addTo(command);
    command.footer(
        "Exit codes: 0 done, 1 usage, 2 input or output failed, 3 with --strict: a scan could not "
        "be reduced; of several logs, the worst: 2, then 3, then 1");
    command.callback([options, &exitCode] {
        const std::vector<ReduceFiles> logs = filesOf(*options);
        const rawlog::Config config = options->shared.readConfig();
        requireRefinedPoses(*options, config);
        const LoadedMap map = options->shared.readMap(config);
        for (const std::string& warning : map.warnings) say(stderr, "warning: {}\n", warning);
        const ReduceJob job{*options, config, map};
        exitCode =
            writesFolders(*options) ? reduceBatch(job, logs) : reduceAlone(job, logs.front());
    });
}

}  // namespace offmap::app
