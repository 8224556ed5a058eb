// SPDX-License-Identifier: BSD-3-Clause
#include "VisitedLog.h"

#include "../SensorLabels.h"
#include "input/UsageError.h"

#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnSearch.h>

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace offmap::app {

using mrpt::obs::CObservation;

VisitedLog lookAt(const std::filesystem::path& log, const PoseOptions& poses,
                  const rawlog::Config& config, rawlog::GuardedStatus& status) {
    VisitedLog visited;
    visited.file = log;
    rawlog::RawlogReader reader(log);
    visited.survey = rawlog::surveyLog(reader, config, std::numeric_limits<uint64_t>::max(),
                                       [&] { status.atEntry(reader.place()); });
    if (visited.survey.damage) throw *visited.survey.damage;
    if (!visited.survey.holdsScans()) {
        throw std::runtime_error(
            fmt::format("{} holds no 3D scan that could be used; offmap info tells what it holds",
                        log.string()));
    }
    visited.warnings = checkSingleSensors(config, visited.survey, log);
    try {
        visited.poses = rawlog::choosePoses(poses.request(), config, visited.survey, log, false);
    } catch (const rawlog::PoseRequestError& error) {
        throw UsageError(error.what());
    }
    if (!visited.poses.warning.empty()) visited.warnings.push_back(visited.poses.warning);
    return visited;
}

void visitTurns(
    const VisitedLog& log, const core::LineMap& map, const rawlog::Config& config,
    rawlog::GuardedStatus& status,
    const std::function<void(const rawlog::ReducedTurn&, const core::ReductionResult&)>& visit) {
    rawlog::TurnReducer reducer(map, *log.poses.source, config, rawlog::OutputClass::Same);
    rawlog::TurnAssembler assembler(config, log.file);
    rawlog::expectSweepsOf(log.survey, assembler);
    const auto reduceAll = [&](const std::vector<rawlog::PlacedTurn>& turns) {
        for (const auto& [turn, first, last] : turns) {
            const CObservation& obs = *turn.front();
            const auto* scanClass = rawlog::scanClassOf(obs, config.sensorOf(obs.sensorLabel));
            const rawlog::ReducedTurn reduced = reducer.reduce(turn, *scanClass);
            visit(reduced, reducer.result());
        }
    };
    rawlog::RawlogReader reader(log.file);
    for (uint64_t index = 0; index < log.survey.entries; ++index) {
        status.atEntry(reader.place());
        const auto entry = reader.next();
        if (!entry) throw std::runtime_error(log.file.string() + " became shorter while read");
        rawlog::forEachObservation(entry->object, [&](const CObservation::Ptr& obs, size_t) {
            if (log.survey.reducible(*obs, config.sensorOf(obs->sensorLabel)))
                reduceAll(assembler.add(obs, index));
        });
    }
    reduceAll(assembler.finish());
}

}  // namespace offmap::app
