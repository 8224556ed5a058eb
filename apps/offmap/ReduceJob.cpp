// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceJob.h"

#include "Console.h"
#include "Progress.h"
#include "SummaryText.h"
#include "UsageError.h"

#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/rawlog/LogReduction.h>
#include <offmap/rawlog/ParameterTable.h>
#include <offmap/rawlog/ReportFile.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <optional>

namespace offmap::app {

using nlohmann::ordered_json;

namespace {

using SteadyClock = std::chrono::steady_clock;

/// The outputs of one reduction, all of which are complete before the first one appears.
struct Outputs {
    Outputs(const ReduceOptions& options, rawlog::GuardedStatus& status) {
        rawlog::OutputOptions rawlogOptions{6, options.force, &status};
        reduced.emplace(options.output, rawlogOptions);
        if (!options.removed.empty()) removed.emplace(options.removed, rawlogOptions);
        if (!options.report.empty()) {
            report.emplace(options.report,
                           rawlog::OutputOptions{std::nullopt, options.force, &status});
        }
    }

    std::optional<rawlog::RawlogWriter> reduced, removed;
    std::optional<rawlog::ReportFile> report;
};

/// \throw UsageError if a sensor that was asked for has no scan that could be reduced
void requireSensors(const ReduceOptions& options, const rawlog::LogSurvey& survey) {
    std::vector<std::string> known;
    for (const auto& [label, sensor] : survey.sensors) {
        if (sensor.scans3d) known.push_back(label);
    }
    for (const std::string& label : options.sensors) {
        if (std::ranges::count(known, label) > 0) continue;
        throw UsageError(
            fmt::format("{} holds no 3D scan labelled '{}' that could be reduced; it holds: {}",
                        options.input.string(), label,
                        known.empty() ? "none at all" : fmt::format("{}", fmt::join(known, ", "))));
    }
}

void requireScans(const ReduceOptions& options, const rawlog::LogSurvey& survey) {
    if (survey.holdsScans() || options.keepGoing) return;
    std::vector<std::string> seen;
    for (const auto& [label, sensor] : survey.sensors) {
        seen.push_back(fmt::format("{} ({} x {}{}{})", label.empty() ? "no label" : label,
                                   rawlog::grouped(sensor.observations), sensor.className,
                                   sensor.unsupported ? ": " : "",
                                   sensor.unsupported.value_or("")));
    }
    throw std::runtime_error(
        fmt::format("{} holds no 3D scan that could be reduced, only: {}; a VLP-16, a rotating "
                    "scan, a point cloud or a 2D scanner that turns about the vertical is needed "
                    "(--keep-going copies the log)",
                    options.input.string(),
                    seen.empty() ? "no observation" : fmt::format("{}", fmt::join(seen, ", "))));
}

ordered_json reportHead(const ReduceOptions& options, const rawlog::Config& config,
                        const core::LineMap& map, const rawlog::ChosenPoses& poses) {
    ordered_json parameters = ordered_json::object();
    for (const rawlog::Parameter& parameter : rawlog::parameters()) {
        parameters[std::string(parameter.key)] = parameter.text(config);
    }
    ordered_json head;
    head["offmap"] = OFFMAP_VERSION;
    head["input"] = options.input.string();
    head["map"] = {{"file", options.shared.map.string()}, {"walls", map.walls().size()}};
    head["poses"] = poses.description;
    head["parameters"] = parameters;
    return head;
}

struct SurveyedLog {
    rawlog::LogSurvey survey;
    std::string endsBecause;  ///< as in ReadableLog
};

/// Reads the log a first time. \throw std::runtime_error if it is damaged and not to be read on
SurveyedLog readFirst(const ReduceOptions& options, const rawlog::Config& config,
                      const ReadableLog& readable, rawlog::GuardedStatus& status) {
    Progress progress(options.quiet);
    rawlog::RawlogReader reader(options.input);
    const auto size = static_cast<double>(reader.compressedSize());
    SurveyedLog log;
    log.survey = rawlog::surveyLog(reader, config, readable.entries, [&] {
        status.atEntry(reader.place());
        progress.tellSurvey(static_cast<double>(reader.compressedPosition()) / size);
    });
    log.endsBecause = readable.endsBecause;
    if (!log.survey.damage) return log;
    if (log.survey.entries == 0) throw *log.survey.damage;
    log.endsBecause = log.survey.damage->what();
    if (options.keepGoing) return log;
    throw std::runtime_error(log.endsBecause + "; --keep-going writes what stands before it");
}

/// Reads the log a second time and writes the outputs, which then are complete but not yet
/// published.
rawlog::ReductionTotals writeOutputs(const ReduceOptions& options, const rawlog::Config& config,
                                     const core::LineMap& map, const rawlog::LogSurvey& survey,
                                     const rawlog::PoseSource& poses, Outputs& outputs,
                                     rawlog::GuardedStatus& status) {
    rawlog::ReductionTotals totals;
    Progress progress(options.quiet);
    const auto outputClass =
        options.outputClass == "points" ? rawlog::OutputClass::Points : rawlog::OutputClass::Same;
    rawlog::TurnReducer reducer(map, poses, config, outputClass);
    rawlog::LogReduction reduction(
        survey, reducer, config,
        {options.input, {options.sensors.begin(), options.sensors.end()}, options.keepGoing},
        *outputs.reduced, outputs.removed ? &*outputs.removed : nullptr);
    reduction.onTurn = [&](const rawlog::ReducedTurn& turn) {
        totals.add(turn.record);
        if (outputs.report) outputs.report->add(turn.record);
    };
    reduction.onNotSupported = [&](const std::string& reason) { ++totals.notSupported[reason]; };

    rawlog::RawlogReader reader(options.input);
    for (uint64_t entries = 0; entries < survey.entries; ++entries) {
        status.atEntry(reader.place());
        const auto entry = reader.next();
        if (!entry)
            throw std::runtime_error(options.input.string() + " became shorter while it was read");
        reduction.add(*entry);
        progress.tell(static_cast<double>(entries) / static_cast<double>(survey.entries),
                      totals.scans, totals.logSeconds());
    }
    reduction.finish();
    outputs.reduced->finish();
    if (outputs.removed) outputs.removed->finish();
    return totals;
}

/// "212.4 MB"
std::string size(const std::filesystem::path& file) {
    const auto bytes = static_cast<double>(std::filesystem::file_size(file));
    return bytes < 1e6 ? fmt::format("{:.1f} kB", bytes / 1e3)
                       : fmt::format("{:.1f} MB", bytes / 1e6);
}

void publish(Outputs& outputs, rawlog::GuardedStatus& status) {
    status.beginPublishing();
    if (outputs.removed) outputs.removed->publish();
    if (outputs.report) outputs.report->publish();
    outputs.reduced->publish();  // last: where it is, the others are
}

}  // namespace

int reduceLog(const ReduceOptions& options, const rawlog::Config& config, const core::LineMap& map,
              const ReadableLog& readable, rawlog::GuardedStatus& status) {
    const auto begin = SteadyClock::now();
    Outputs outputs(options, status);
    const auto [survey, endsBecause] = readFirst(options, config, readable, status);
    requireSensors(options, survey);
    requireScans(options, survey);
    const rawlog::ChosenPoses poses =
        choosePoses(options.shared, config, options.input, survey, options.keepGoing);
    if (!options.quiet) {
        say(stdout, "map     {}\nposes   {}\n", describe(map, options.shared.map.string()),
            poses.description);
    }

    if (outputs.report) outputs.report->begin(reportHead(options, config, map, poses));
    const rawlog::ReductionTotals totals =
        writeOutputs(options, config, map, survey, *poses.source, outputs, status);
    std::vector<std::string> warnings = totals.warnings();
    if (!endsBecause.empty()) {
        warnings.push_back(fmt::format("only the first {} entries were read: {}",
                                       rawlog::grouped(survey.entries), endsBecause));
    }
    if (outputs.report)
        outputs.report->finish(totals, {{"entries", survey.entries}, {"warnings", warnings}});
    publish(outputs, status);

    if (!options.quiet) {
        const std::chrono::duration<double> took = SteadyClock::now() - begin;
        say(stdout, "{}wrote   {} ({}, was {})\n", summaryOf(totals, took.count()),
            options.output.string(), size(options.output), size(options.input));
    }
    for (const std::string& warning : warnings) say(stderr, "warning: {}\n", warning);
    const bool all = totals.scansNotReduced() == 0 && totals.observationsNotSupported() == 0 &&
                     totals.columnsWithoutPose == 0 && totals.scans > 0;
    return options.strict && !all ? exitNotReduced : exitDone;
}

}  // namespace offmap::app
