// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceJob.h"

#include "ReduceOutputs.h"
#include "SensorLabels.h"
#include "SummaryText.h"
#include "input/Console.h"
#include "input/Progress.h"
#include "input/SensorPoses.h"
#include "input/UsageError.h"

#include <offmap/rawlog/GroupedDigits.h>
#include <offmap/rawlog/LayerSettings.h>
#include <offmap/rawlog/LogReduction.h>
#include <offmap/rawlog/ParameterTable.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

namespace offmap::app {

using nlohmann::ordered_json;

namespace {

using SteadyClock = std::chrono::steady_clock;

/// \throw UsageError if a sensor that was asked for has no scan that could be reduced
void requireSensors(const ReduceOptions& options, const std::filesystem::path& input,
                    const rawlog::LogSurvey& survey) {
    for (const std::string& label : options.sensors) requireScansOf(label, survey, input);
}

/// \throw UsageError if refined poses would mix with what the log has under their label
void requireFreeLabel(const ReduceOptions& options, const std::filesystem::path& input,
                      const rawlog::LogSurvey& survey) {
    if (!options.writePoses) return;
    const std::string& label = *options.writePoses;
    if (label == "actions") {
        throw UsageError(
            "refined poses cannot bear the label 'actions', which --pose-label takes for the "
            "movements of a log; name another one: --write-poses LABEL");
    }
    if (survey.poses.contains(label) || survey.sensors.contains(label)) {
        throw UsageError(
            fmt::format("{} already holds observations of the label '{}', and refined poses need "
                        "one of their own: --write-poses LABEL",
                        input.string(), label));
    }
}

void requireScans(const std::filesystem::path& input, const rawlog::LogSurvey& survey) {
    if (survey.holdsScans()) return;
    std::vector<std::string> seen;
    for (const auto& [label, sensor] : survey.sensors) {
        seen.push_back(fmt::format("{} ({} x {}{}{})", label.empty() ? "no label" : label,
                                   rawlog::grouped(sensor.observations), sensor.className,
                                   sensor.unsupported ? ": " : "",
                                   sensor.unsupported.value_or("")));
    }
    throw std::runtime_error(
        fmt::format("{} holds no 3D scan that could be reduced, only: {}; a Velodyne, a rotating "
                    "scan, a depth camera, a point cloud or a 2D scanner that turns about the "
                    "vertical is needed (--keep-going copies the log)",
                    input.string(),
                    seen.empty() ? "no observation" : fmt::format("{}", fmt::join(seen, ", "))));
}

ordered_json reportHead(const ReduceJob& job, const std::filesystem::path& input,
                        const rawlog::ChosenPoses& poses) {
    ordered_json parameters = ordered_json::object();
    for (const rawlog::Parameter& parameter : rawlog::parameters()) {
        parameters[std::string(parameter.key)] = parameter.text(job.config);
    }
    for (const auto& [label, settings] : job.config.sensors) {
        for (const auto& [name, value] : settings) {
            parameters[fmt::format("sensors.{}.{}", label, name)] = value;
        }
    }
    for (const auto& [key, value] : rawlog::layerSettings(job.config)) {
        parameters[fmt::format("layers.{}.{}", key.layer, key.name)] = value;
    }
    ordered_json sensorPoses = ordered_json::object();
    for (const auto& [label, pose] : job.config.mountings) {
        sensorPoses[label] = sensorPoseText(pose);
    }
    ordered_json head;
    head["offmap"] = OFFMAP_VERSION;
    head["input"] = input.string();
    head["map"] = {{"file", job.options.shared.map.string()},
                   {"format", job.map.format},
                   {"walls", job.map.lines.walls().size()},
                   {"notes", job.map.notes},
                   {"warnings", job.map.warnings}};
    head["poses"] = poses.description;
    head["parameters"] = parameters;
    head["sensor_poses"] = sensorPoses;
    return head;
}

struct SurveyedLog {
    rawlog::LogSurvey survey;
    std::string endsBecause;  ///< as in ReadableLog
};

/// Reads the log a first time. \throw std::runtime_error if it is damaged and not to be read on
SurveyedLog readFirst(const ReduceJob& job, const LogToReduce& log, const ReadableLog& readable,
                      rawlog::GuardedStatus& status, rawlog::StageTimes& times) {
    const rawlog::StageTimes::Measure measure(times, rawlog::StageTimes::Survey);
    Progress progress(job.options.quiet, log.title);
    rawlog::RawlogReader reader(log.files.input, {}, {.ahead = true, .times = &times});
    const auto size = static_cast<double>(reader.compressedSize());
    SurveyedLog surveyed;
    surveyed.survey = rawlog::surveyLog(reader, job.config, readable.entries, [&] {
        status.atEntry(reader.place());
        progress.tellSurvey(static_cast<double>(reader.compressedPosition()) / size);
    });
    surveyed.endsBecause = readable.endsBecause;
    const auto& damage = surveyed.survey.damage;
    if (!damage) return surveyed;
    if (surveyed.survey.entries == 0) throw *damage;
    surveyed.endsBecause = damage->what();
    if (job.options.keepGoing) return surveyed;
    throw std::runtime_error(surveyed.endsBecause + "; --keep-going writes what stands before it");
}

/// [s] that processors worked for each stage.
ordered_json toJson(const rawlog::StageTimes& times) {
    using rawlog::StageTimes;
    ordered_json json;
    for (size_t stage = 0; stage < StageTimes::Count; ++stage) {
        const double seconds = times.seconds(static_cast<StageTimes::Stage>(stage));
        json[std::string(StageTimes::names[stage])] = std::round(1000 * seconds) / 1000;
    }
    return json;
}

/// Reads the log a second time and writes the outputs.
rawlog::ReductionTotals writeOutputs(const ReduceJob& job, const LogToReduce& log,
                                     const rawlog::LogSurvey& survey,
                                     const rawlog::PoseSource& poses, ReduceOutputs& outputs,
                                     rawlog::GuardedStatus& status, rawlog::StageTimes& times) {
    const ReduceOptions& options = job.options;
    const rawlog::Config& config = job.config;
    const LoadedMap& map = job.map;
    const std::filesystem::path& input = log.files.input;
    rawlog::ReductionTotals totals;
    Progress progress(options.quiet, log.title);
    const auto outputClass =
        options.outputClass == "points" ? rawlog::OutputClass::Points : rawlog::OutputClass::Same;
    rawlog::LogReduction::Outputs logs = outputs.logs();
    logs.poseLabel = options.writePoses.value_or("");
    rawlog::LogReduction reduction(
        survey, config,
        {input, {options.sensors.begin(), options.sensors.end()}, options.keepGoing},
        [&] { return rawlog::TurnReducer(map.lines, poses, config, outputClass); }, logs, times);
    reduction.beforeEntry = [&](const rawlog::EntryPlace& place) { status.atEntry(place); };
    reduction.describe = [&](uint64_t number, const rawlog::ReducedTurn& turn,
                             const core::ReductionResult& result) {
        return outputs.notesOf(number, turn, result, map.lines);
    };
    reduction.onTurn = [&](const rawlog::TurnRecord& turn, const rawlog::TurnNotes& notes) {
        totals.add(turn);
        outputs.add(turn, notes);
    };
    reduction.onNotSupported = [&](const std::string& reason) { ++totals.notSupported[reason]; };
    reduction.onEntries = [&](uint64_t entries) {
        progress.tell(static_cast<double>(entries) / static_cast<double>(survey.entries),
                      totals.scans, totals.logSeconds());
    };
    rawlog::RawlogReader reader(input, {}, {.ahead = true, .times = &times});
    reduction.run(reader);
    return totals;
}

ReducedLog reduceInThreads(const ReduceJob& job, const LogToReduce& log,
                           const ReadableLog& readable, rawlog::GuardedStatus& status) {
    const auto begin = SteadyClock::now();
    const ReduceOptions& options = job.options;
    const std::filesystem::path& input = log.files.input;
    ReduceOutputs outputs(log.files, options, status);
    rawlog::StageTimes times;
    const auto [survey, endsBecause] = readFirst(job, log, readable, status, times);
    requireSensors(options, input, survey);
    requireFreeLabel(options, input, survey);
    if (!options.keepGoing) requireScans(input, survey);
    const auto sensorWarnings = checkSingleSensors(job.config, survey, input);
    const rawlog::ChosenPoses poses =
        choosePoses(options.shared, job.config, input, survey, options.keepGoing);
    if (!options.quiet && log.title.empty()) {
        say(stdout, "{}poses   {}\n", summaryOf(job.map), poses.description);
    }

    outputs.begin(reportHead(job, input, poses));
    ReducedLog reduced;
    reduced.totals = writeOutputs(job, log, survey, *poses.source, outputs, status, times);
    reduced.warnings = reduced.totals.warnings();
    if (!poses.warning.empty()) reduced.warnings.push_back(poses.warning);
    reduced.warnings.insert(reduced.warnings.end(), sensorWarnings.begin(), sensorWarnings.end());
    if (!endsBecause.empty()) {
        reduced.warnings.push_back(fmt::format("only the first {} entries were read: {}",
                                               rawlog::grouped(survey.entries), endsBecause));
    }
    outputs.finish(reduced.totals, {{"entries", survey.entries},
                                    {"stage_seconds", toJson(times)},
                                    {"warnings", reduced.warnings}});
    outputs.publish();
    reduced.seconds = std::chrono::duration<double>(SteadyClock::now() - begin).count();
    return reduced;
}

}  // namespace

ReducedLog reduceLog(const ReduceJob& job, const LogToReduce& log, const ReadableLog& readable,
                     rawlog::GuardedStatus& status) {
    const size_t threads = job.options.threadCount();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(static_cast<int>(threads));
    return arena.execute([&] { return reduceInThreads(job, log, readable, status); });
}

}  // namespace offmap::app
