// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LogTurns.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/ScanClasses.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <chrono>
#include <utility>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;

LogTurns::LogTurns(const LogSurvey& survey, const Config& config, Settings settings)
    : survey_(survey), configs_(config), settings_(std::move(settings)) {}

void LogTurns::add(const RawlogEntry& entry, LogStretch& to) {
    const auto& added = to.entries.emplace_back(std::make_shared<LogEntry>());
    added->index = entry.place.index;
    added->bytes.assign(entry.bytes.begin(), entry.bytes.end());
    to.bytes += entry.bytes.size();
    forEachObservation(entry.object, [&](const CObservation::Ptr& obs, size_t position) {
        endOverdueTurns(obs->timestamp, to);
        const bool chosen =
            settings_.sensors.empty() || settings_.sensors.contains(obs->sensorLabel);
        if (!chosen) return;
        const SensorConfig& config = configs_.of(obs->sensorLabel);
        if (survey_.reducible(*obs, config)) {
            added->object = entry.object;
            addObservation({added, position, obs}, to);
        } else if (auto reason = unsupportedReason(*obs, config)) {
            to.notSupported.push_back(std::move(*reason));
        }
    });
}

void LogTurns::addObservation(TurnMember member, LogStretch& to) {
    if (!loadIfExternal(member, to)) return;
    ++member.entry->unresolved;
    const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(member.obs.get());
    if (!scan) {
        std::vector<std::vector<TurnMember>> turn(1);
        turn.front().push_back(std::move(member));
        return addTurns(std::move(turn), to);
    }
    const std::string& label = scan->sensorLabel;
    auto open = open_.find(label);
    if (open == open_.end()) {
        const SensorConfig& config = configs_.of(label);
        OpenTurn turn{TurnCollector<TurnMember>(config), config.maxColumnPause};
        open = open_.emplace(label, std::move(turn)).first;
    }
    addTurns(open->second.columns.add(*scan, std::move(member)), to);
}

/// False if it is to be copied as it is, because its file cannot be loaded.
bool LogTurns::loadIfExternal(TurnMember& member, LogStretch& to) {
    try {
        const SensorConfig& config = configs_.of(member.obs->sensorLabel);
        member.loaded =
            scanClassOf(*member.obs, config)->loadExternal(*member.obs, settings_.input);
        return true;
    } catch (const std::exception&) {
        if (!settings_.keepGoing) throw;
        to.notSupported.emplace_back("externally stored, and its file cannot be read");
        return false;
    }
}

void LogTurns::endOverdueTurns(mrpt::Clock::time_point now, LogStretch& to) {
    for (auto& [label, turn] : open_) {
        const std::chrono::duration<double> longest(turn.maxPause);
        if (!turn.columns.empty() && now - turn.columns.latest().obs->timestamp > longest)
            addTurns(turn.columns.finish(), to);
    }
}

void LogTurns::addTurns(std::vector<std::vector<TurnMember>> turns, LogStretch& to) {
    for (std::vector<TurnMember>& members : turns) {
        const CObservation& first = *members.front().obs;
        to.turns.push_back(
            {turns_++, scanClassOf(first, configs_.of(first.sensorLabel)), std::move(members)});
    }
}

void LogTurns::finish(LogStretch& to) {
    for (auto& [label, turn] : open_) addTurns(turn.columns.finish(), to);
}

}  // namespace offmap::rawlog
