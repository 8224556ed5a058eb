// SPDX-License-Identifier: BSD-3-Clause
#include "LogTurns.h"

#include "../SensorLabels.h"
#include "../UsageError.h"

#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnCollector.h>

#include <fmt/format.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <limits>
#include <map>
#include <stdexcept>

namespace offmap::app {

using mrpt::obs::CObservation;
using rawlog::Turn;

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

namespace {

/// Gathers observations into turns.
class Turns {
 public:
    Turns(const VisitedLog& log, const rawlog::Config& config,
          std::function<void(const Turn&, const rawlog::ScanClass&)> visit)
        : log_(log), config_(config), visit_(std::move(visit)) {}

    void add(const CObservation::Ptr& obs) {
        const rawlog::SensorConfig own = config_.sensorOf(obs->sensorLabel);
        if (!log_.survey.reducible(*obs, own)) return;
        const rawlog::ScanClass* scanClass = rawlog::scanClassOf(*obs, own);
        scanClass->loadExternal(*obs, log_.file);
        const auto* sweep = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(obs.get());
        if (!sweep) return visit_({obs}, *scanClass);
        auto& open = open_.try_emplace(obs->sensorLabel, own).first->second;
        for (const Turn& turn : open.add(*sweep, obs)) visit_(turn, *scanClass);
    }

    void finish() {
        for (auto& [label, open] : open_) {
            for (const Turn& turn : open.finish()) {
                visit_(turn, *rawlog::scanClassOf(*turn.front(), config_.sensorOf(label)));
            }
        }
    }

 private:
    const VisitedLog& log_;
    const rawlog::Config& config_;
    std::function<void(const Turn&, const rawlog::ScanClass&)> visit_;
    std::map<std::string, rawlog::TurnCollector<CObservation::ConstPtr>> open_;  // by label
};

}  // namespace

void visitTurns(
    const VisitedLog& log, const core::LineMap& map, const rawlog::Config& config,
    rawlog::GuardedStatus& status,
    const std::function<void(const rawlog::ReducedTurn&, const core::ReductionResult&)>& visit) {
    rawlog::TurnReducer reducer(map, *log.poses.source, config, rawlog::OutputClass::Same);
    Turns turns(log, config, [&](const Turn& turn, const rawlog::ScanClass& scanClass) {
        const rawlog::ReducedTurn reduced = reducer.reduce(turn, scanClass);
        visit(reduced, reducer.result());
    });
    rawlog::RawlogReader reader(log.file);
    for (uint64_t index = 0; index < log.survey.entries; ++index) {
        status.atEntry(reader.place());
        const auto entry = reader.next();
        if (!entry) throw std::runtime_error(log.file.string() + " became shorter while read");
        rawlog::forEachObservation(entry->object,
                                   [&](const CObservation::Ptr& obs, size_t) { turns.add(obs); });
    }
    turns.finish();
}

}  // namespace offmap::app
