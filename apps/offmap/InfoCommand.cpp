// SPDX-License-Identifier: BSD-3-Clause
#include "InfoCommand.h"

#include "InfoJson.h"
#include "InfoText.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/UsageError.h"

#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/GuardedRun.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

namespace offmap::app {

namespace {

/// \throw UsageError if a sensor that was asked for is not in the log
void requireSensors(const InfoOptions& options, const LogFacts& facts) {
    std::vector<std::string> known;
    for (const auto& [sensor, inventory] : facts.inventory->sensors()) {
        if (inventory.scans3d) known.push_back(sensor.first);
    }
    for (const std::string& label : options.sensors) {
        if (std::ranges::count(known, label) > 0) continue;
        throw UsageError(
            fmt::format("{} holds no 3D scan labelled '{}'; it holds: {}", options.input.string(),
                        label, known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    }
}

int tell(const InfoOptions& options, const rawlog::Config& config, const ReadableLog& readable,
         rawlog::GuardedStatus& status) {
    const LogFacts facts = gatherFacts(options, config, readable, status);
    requireSensors(options, facts);
    const Advice advice = adviceFor(facts, options, config);
    say(stdout, "{}", options.json ? infoJson(facts, advice) : infoText(facts, advice));
    for (const std::string& warning : facts.warnings) say(stderr, "warning: {}\n", warning);
    if (facts.damage.empty()) return exitDone;
    say(stderr, "offmap: {}\n", facts.damage);
    return exitFailed;
}

int tellGuarded(const InfoOptions& options, const rawlog::Config& config,
                const ReadableLog& readable) {
    using Kind = rawlog::GuardedOutcome::Kind;
    const rawlog::GuardedOutcome outcome = reportingErrorsGuarded(
        [&](rawlog::GuardedStatus& status) { return tell(options, config, readable, status); });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    const std::string what = rawlog::unreadableEntry(
        options.input, outcome.place.value_or(rawlog::EntryPlace{}), outcome.cause);
    const uint64_t readableEntries = outcome.place ? outcome.place->index : 0;
    if (readableEntries > 0 && readableEntries < readable.entries) {
        return tellGuarded(options, config, {readableEntries, what});
    }
    say(stderr, "offmap: {}\n", what);
    return exitFailed;
}

}  // namespace

void addInfoCommand(CLI::App& app, int& exitCode) {
    CLI::App& command =
        *app.add_subcommand("info", "Tell what a rawlog holds, and what it takes to reduce it");
    const auto options = std::make_shared<InfoOptions>();
    options->addTo(command);
    command.footer(
        "The options of `reduce` may be given to see whether anything is still missing.\n"
        "Exit codes: 0 the log was read to its end, 1 usage, 2 it cannot be read or is damaged");
    command.callback([&command, options, &exitCode] {
        options->rememberForReduce(command);
        const rawlog::Config config = options->shared.readConfig();
        if (!options->shared.map.empty()) options->shared.readMap(config);
        exitCode = tellGuarded(*options, config, {});
    });
}

}  // namespace offmap::app
