// SPDX-License-Identifier: BSD-3-Clause
#include "SensorLabels.h"

#include "input/UsageError.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace offmap::app {

namespace {

bool holdsScansOf(const std::string& label, const rawlog::LogSurvey& survey) {
    const auto sensor = survey.sensors.find(label);
    return sensor != survey.sensors.end() && sensor->second.scans3d;
}

/// "LEFT, RIGHT" or "none at all"
std::string scanLabels(const rawlog::LogSurvey& survey) {
    std::vector<std::string> labels;
    for (const auto& [label, sensor] : survey.sensors) {
        if (sensor.scans3d) labels.push_back(label.empty() ? "'' (no label)" : label);
    }
    return labels.empty() ? "none at all" : fmt::format("{}", fmt::join(labels, ", "));
}

}  // namespace

void requireScansOf(const std::string& label, const rawlog::LogSurvey& survey,
                    const std::filesystem::path& log) {
    if (holdsScansOf(label, survey)) return;
    throw UsageError(
        fmt::format("{} holds no 3D scan labelled '{}' that could be reduced; it holds: {}",
                    log.string(), label, scanLabels(survey)));
}

std::vector<std::string> checkSingleSensors(const rawlog::Config& config,
                                            const rawlog::LogSurvey& survey,
                                            const std::filesystem::path& log) {
    for (const auto& [label, pose] : config.mountings) {
        requireScansOf(label, survey, log);
        if (!survey.sensors.at(label).sweep.isSweep()) continue;
        throw UsageError(fmt::format(
            "--sensor-pose cannot place '{}': it is a turned 2D scanner, whose pose differs in "
            "each scan; correct the poses in the log",
            label));
    }
    std::vector<std::string> warnings;
    for (const auto& [label, settings] : config.sensors) {
        if (holdsScansOf(label, survey)) continue;
        warnings.push_back(fmt::format(
            "the settings sensors.{}.* had no effect: {} holds no 3D scan of that label that could "
            "be reduced, but of: {}",
            label, log.string(), scanLabels(survey)));
    }
    return warnings;
}

}  // namespace offmap::app
