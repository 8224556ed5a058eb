// SPDX-License-Identifier: BSD-3-Clause
#include "InfoAdvice.h"

#include "InfoPoseAdvice.h"
#include "PlainText.h"
#include "TextSections.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace offmap::app {

namespace {

using rawlog::SensorInventory;

/// A reason that names this parameter goes away when it is set.
constexpr std::string_view elevationsKey = "elevations_deg";

bool elevationsHelp(const SensorInventory& sensor) {
    return std::ranges::any_of(sensor.notReducible, [](const auto& reason) {
        return reason.first.find(elevationsKey) != std::string::npos;
    });
}

/// The sensors that hold 3D scans and are to be reduced.
std::map<std::string, const SensorInventory*> chosenScanners(const LogFacts& facts,
                                                             const InfoOptions& options) {
    std::map<std::string, const SensorInventory*> chosen;
    for (const auto& [key, sensor] : facts.inventory->sensors()) {
        if (sensor.scans3d && options.chooses(key.first)) chosen[key.first] = &sensor;
    }
    return chosen;
}

void adviseSensor(const std::string& label, const SensorInventory& sensor, Advice& advice) {
    if (elevationsHelp(sensor)) {
        advice.missing.push_back(
            {fmt::format("the elevations of the rows of {}, row 0 first, separated by commas",
                         nameOf(label)),
             {"--set", fmt::format("{}.{}=[ELEVATIONS_DEG]",
                                   label.empty() ? "sensor" : "sensors." + label, elevationsKey)}});
    }
    if (sensor.scans > 0 && sensor.onVerticalSegments == 0) {
        advice.missing.push_back(
            {fmt::format(
                 "vertical segments: the scans of {} hold none, and only these are removed; "
                 "a scanner of a single row has none, for others try a preset or other "
                 "values of vertical.*",
                 nameOf(label)),
             {}});
    }
    if (sensor.externalMissing > 0) {
        advice.missing.push_back(
            {fmt::format(
                 "{} of {} files that hold the points of {}: {}. Without them, --keep-going "
                 "copies these observations as they are",
                 sensor.externalMissing, sensor.external, nameOf(label),
                 printable(sensor.externalProblem)),
             {}});
    }
}

void advisePreset(const std::map<std::string, const SensorInventory*>& scanners,
                  const InfoOptions& options, Advice& advice) {
    if (!options.shared.config.file.empty()) return;
    std::set<std::string> presets;
    for (const auto& [label, sensor] : scanners) presets.insert(presetFor(sensor->model.name));
    if (presets.size() == 1 && !presets.begin()->empty()) {
        advice.hints.push_back({"the preset for this sensor", {"--config", *presets.begin()}});
        return;
    }
    for (const auto& [label, sensor] : scanners) {
        const std::string preset = presetFor(sensor->model.name);
        if (preset.empty()) continue;
        advice.hints.push_back(
            {fmt::format("by itself, with --sensor {}, {} has a preset: --config {}",
                         shellWord(label), nameOf(label), preset),
             {}});
    }
}

/// "run7.reduced.rawlog" for run7.rawlog and run7.rawlog.gz
std::string outputFor(const std::filesystem::path& file) {
    std::filesystem::path name = file.filename();
    for (const char* known : {".gz", ".rawlog"}) {
        if (name.extension() == known) name = name.stem();
    }
    return name.string() + ".reduced.rawlog";
}

/// A file name that no program takes for an option.
std::string fileWord(const std::filesystem::path& file) {
    return file.string().starts_with('-') ? "./" + file.string() : file.string();
}

void compose(const LogFacts& facts, const InfoOptions& options, Advice& advice) {
    advice.command = {"offmap", "reduce", fileWord(facts.file)};
    std::vector<std::string>& words = advice.command;
    words.insert(words.end(), options.forReduce.begin(), options.forReduce.end());
    for (const auto* steps : {&advice.missing, &advice.hints}) {
        for (const AdviceStep& step : *steps) {
            words.insert(words.end(), step.words.begin(), step.words.end());
        }
    }
    if (!facts.damage.empty()) words.emplace_back("--keep-going");
    words.insert(words.end(), {"-o", fileWord(outputFor(facts.file))});
    for (const char* known : {"MAP", "X,Y,YAW_DEG", "SECONDS", "ELEVATIONS_DEG"}) {
        const bool used = std::ranges::any_of(advice.missing, [known](const AdviceStep& step) {
            return !step.words.empty() && step.words.back().find(known) != std::string::npos;
        });
        if (used) advice.placeholders.emplace_back(known);
    }
}

}  // namespace

std::string presetFor(const std::string& modelName) {
    const auto contains = [&](std::string_view part) {
        return modelName.find(part) != std::string::npos;
    };
    if (contains("VLP-16") || contains("VLP16")) return "vlp16";
    if (contains("HDL-32") || contains("HDL32")) return "hdl32";
    if (modelName == "depth camera") return "depth_camera";
    return {};
}

Advice adviceFor(const LogFacts& facts, const InfoOptions& options, const rawlog::Config& config) {
    Advice advice;
    const auto scanners = chosenScanners(facts, options);
    advice.hasScans = std::ranges::any_of(scanners, [](const auto& scanner) {
        return scanner.second->reducible > 0 || scanner.second->externalMissing > 0 ||
               elevationsHelp(*scanner.second);
    });
    if (!advice.hasScans) return advice;
    for (const auto& [label, sensor] : scanners) adviseSensor(label, *sensor, advice);
    if (options.shared.map.empty()) {
        advice.missing.push_back(
            {"a map of the walls, in the frame of the poses: a drawing, an occupancy grid, or a "
             "text "
             "file, one wall a line, x1 y1 x2 y2 in metres",
             {"--map", "MAP"}});
    }
    advisePoses(facts, config, advice);
    advisePreset(scanners, options, advice);
    compose(facts, options, advice);
    return advice;
}

}  // namespace offmap::app
