// SPDX-License-Identifier: BSD-3-Clause
#include "TurnCount.h"

#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/TurnAssembler.h>
#include <offmap/rawlog/TurnSearch.h>

#include <algorithm>

namespace offmap::window {

namespace {

/// Whether observations of a sensor may be other than one turn each.
bool mustBeRead(const rawlog::LogSurvey& survey) {
    return std::ranges::any_of(survey.sensors, [](const auto& labelled) {
        const auto& [label, sensor] = labelled;
        // Without a label, several sensors may be meant.
        return sensor.sweep.isSweep() || (sensor.scans3d && (sensor.unsupported || label.empty()));
    });
}

uint64_t scansIn(const rawlog::LogSurvey& survey) {
    uint64_t scans = 0;
    for (const auto& [label, sensor] : survey.sensors) {
        if (sensor.scans3d) scans += sensor.observations;
    }
    return scans;
}

}  // namespace

uint64_t turnsIn(const std::filesystem::path& log, const rawlog::LogSurvey& survey,
                 const rawlog::Config& config, const std::function<void()>& onEntry) {
    if (!mustBeRead(survey)) return scansIn(survey);
    rawlog::RawlogReader reader(log);
    rawlog::TurnAssembler assembler(config, log);
    rawlog::expectSweepsOf(survey, assembler);
    uint64_t turns = 0;
    for (uint64_t i = 0; i < survey.entries; ++i) {
        onEntry();
        const auto entry = reader.next();
        if (!entry) break;
        rawlog::forEachObservation(
            entry->object, [&](const mrpt::obs::CObservation::Ptr& obs, size_t) {
                if (survey.reducible(*obs, config.sensorOf(obs->sensorLabel))) {
                    turns += assembler.add(obs, entry->place.index).size();
                }
            });
    }
    return turns + assembler.finish().size();
}

}  // namespace offmap::window
