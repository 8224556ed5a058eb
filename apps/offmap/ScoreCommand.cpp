// SPDX-License-Identifier: BSD-3-Clause
#include "ScoreCommand.h"

#include "LogScore.h"
#include "ScoreText.h"
#include "TextSections.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/NamedFiles.h"
#include "input/NumberList.h"
#include "input/Presets.h"
#include "input/UsageError.h"

#include <offmap/rawlog/ConfigFile.h>
#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/OutputFile.h>

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>

namespace offmap::app {

namespace {

struct ScoreOptions {
    ScoredFiles files;
    std::filesystem::path json, config;
    std::vector<std::string> settings;  ///< "key=value"
    bool partial = false, force = false;

    void addTo(CLI::App& command) {
        command.add_option("TRUTH", files.truth, "Truth of the log before it was reduced")
            ->required()
            ->type_name("F.csv[.gz]");
        command.add_option("REDUCED", files.log, "The reduced log; it is only read")
            ->required()
            ->type_name("FILE");
        command.add_option("--json", json, "The score for programs, in a file")
            ->type_name("F.json")
            ->check(notEmpty);
        command
            .add_option("--config", config,
                        "The parameters that the log was reduced with, or a preset's name; needed "
                        "where a sensor's points depend on them (sensor.elevations_deg)")
            ->type_name("FILE.yaml|NAME")
            ->check(notEmpty);
        command.add_option("--set", settings, "One parameter, after --config; may be repeated")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        command.add_flag("--partial", partial,
                         "Score the observations that are in both, where some are in one only");
        command.add_flag("--force", force, "Replace an existing F.json");
    }

    rawlog::Config readConfig() const {
        rawlog::Config out;
        try {
            if (!config.empty()) rawlog::applyYaml(out, configFile(config));
            for (const std::string& setting : settings) rawlog::applySetting(out, setting);
            out.validate();
        } catch (const std::exception& error) {
            throw UsageError(error.what());
        }
        return out;
    }
};

/// What the two files do not share, with --partial a warning.
std::vector<std::string> differences(const LogScore& score, const ScoredFiles& files) {
    std::vector<std::string> found;
    const auto add = [&](const Unmatched& unmatched, const std::filesystem::path& here,
                         const std::filesystem::path& there, const std::string& more) {
        if (unmatched.observations == 0) return;
        found.push_back(fmt::format("{} with {} of {} {} not in {}, first {}{}",
                                    counted(unmatched.observations, "observation"),
                                    counted(unmatched.points, "point"), here.string(),
                                    unmatched.observations == 1 ? "is" : "are", there.string(),
                                    unmatched.first, more));
    };
    add(score.missing, files.truth, files.log,
        score.cannotBeRead.empty() ? "" : "; it cannot be read there: " + score.cannotBeRead);
    add(score.unknown, files.log, files.truth, "");
    return found;
}

/// \throw std::runtime_error if no score could be given, or not of all
void requireSameLog(const LogScore& score, const ScoreOptions& options) {
    const ScoredFiles& files = options.files;
    if (score.observations == 0 && score.missing.observations == 0) {
        throw std::runtime_error(files.truth.string() +
                                 " tells of no return; simulate a log that "
                                 "has some");
    }
    const std::vector<std::string> different = differences(score, files);
    if (score.observations == 0) {
        throw std::runtime_error(
            fmt::format("{} is the truth of another log: {}", files.truth.string(), different[0]));
    }
    if (!different.empty() && !options.partial) {
        throw std::runtime_error(different[0] + "; --partial scores what is in both");
    }
    if (score.foreign.observations == 0) return;
    throw std::runtime_error(fmt::format(
        "{} of {} are not in {}, in {}, first {}: take the truth of the log that was reduced, and "
        "its --config",
        counted(score.foreign.points, "point"), files.log.string(), files.truth.string(),
        counted(score.foreign.observations, "observation"), score.foreign.first));
}

void score(const ScoreOptions& options, const rawlog::Config& config,
           rawlog::GuardedStatus& status) {
    std::optional<rawlog::OutputFile> json;
    if (!options.json.empty()) {
        json.emplace(options.json, rawlog::OutputOptions{{}, options.force, &status});
    }
    const LogScore found = scoreLog(options.files.truth, options.files.log, config, status);
    requireSameLog(found, options);
    if (json) {
        json->write(scoreJson(found, options.files));
        json->finish();
        status.beginPublishing();
        json->publish();
    }
    say(stdout, "{}", scoreText(found, options.files));
    if (json) say(stdout, "{}", section("wrote", {options.json.string()}));
    for (const std::string& difference : differences(found, options.files)) {
        say(stderr, "warning: {}\n", difference);
    }
}

int scoreGuarded(const ScoreOptions& options) {
    using Kind = rawlog::GuardedOutcome::Kind;
    requireDistinct({{"--json", options.json}}, {{"TRUTH", options.files.truth},
                                                 {"REDUCED", options.files.log},
                                                 {"--config", options.config}});
    const rawlog::Config config = options.readConfig();
    const rawlog::GuardedOutcome outcome =
        reportingErrorsGuarded([&](rawlog::GuardedStatus& status) {
            score(options, config, status);
            return static_cast<int>(exitDone);
        });
    if (outcome.kind == Kind::Finished) return outcome.exitCode;
    if (outcome.kind == Kind::Interrupted) return exitCodeOfInterruption(outcome);
    say(stderr, "offmap: {}\n",
        rawlog::unreadableEntry(options.files.log, outcome.place.value_or(rawlog::EntryPlace{}),
                                outcome.cause));
    return exitFailed;
}

}  // namespace

void addScoreCommand(CLI::App& app, int& exitCode) {
    CLI::App& command = *app.add_subcommand(
        "score", "Judge a reduced log by the truth of the log that it was made of");
    const auto options = std::make_shared<ScoreOptions>();
    options->addTo(command);
    command.footer(
        "MR: mapped points removed, UP: unmapped points kept, AA: their geometric mean; pooled by "
        "points.\nExit codes: 0 scored, 1 usage, 2 a file cannot be read, or they do not belong "
        "together");
    command.callback([options, &exitCode] { exitCode = scoreGuarded(*options); });
}

}  // namespace offmap::app
