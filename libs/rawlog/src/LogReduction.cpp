// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LogReduction.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/RefinedPose.h>
#include <offmap/rawlog/ScanClasses.h>

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <chrono>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CSensoryFrame;

namespace {

/// What an entry becomes. \param poses of a frame, to be added to it
template <class Choose, class Replacements>
mrpt::serialization::CSerializable::Ptr replaced(
    const mrpt::serialization::CSerializable::Ptr& object, const Replacements& replacements,
    const std::vector<CObservation::Ptr>& poses, Choose&& choose) {
    const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object);
    if (!frame) return choose(replacements.front());
    auto out = CSensoryFrame::Create();
    size_t position = 0;
    for (const CObservation::Ptr& member : *frame) {
        CObservation::Ptr chosen = member;
        for (const auto& replacement : replacements) {
            if (replacement.position == position && choose(replacement))
                chosen = choose(replacement);
        }
        out->push_back(chosen);
        ++position;
    }
    for (const CObservation::Ptr& pose : poses) out->push_back(pose);
    return out;
}

}  // namespace

LogReduction::LogReduction(const LogSurvey& survey, TurnReducer& reducer, const Config& config,
                           Settings settings, RawlogWriter& reduced, RawlogWriter* removed)
    : survey_(survey),
      reducer_(reducer),
      config_(config),
      settings_(std::move(settings)),
      reduced_(reduced),
      removed_(removed) {}

void LogReduction::add(const RawlogEntry& entry) {
    PendingEntry& pending = pending_.emplace_back();
    pending.index = entry.place.index;
    pending.bytes.assign(entry.bytes.begin(), entry.bytes.end());
    forEachObservation(entry.object, [&](const CObservation::Ptr& obs, size_t position) {
        endOverdueTurns(obs->timestamp);
        const bool chosen =
            settings_.sensors.empty() || settings_.sensors.contains(obs->sensorLabel);
        if (!chosen) return;
        const SensorConfig config = config_.sensorOf(obs->sensorLabel);
        if (survey_.reducible(*obs, config)) {
            pending.object = entry.object;
            addObservation(pending, obs, position);
        } else if (const auto reason = unsupportedReason(*obs, config)) {
            onNotSupported(*reason);
        }
    });
    writeReady();
}

void LogReduction::addObservation(PendingEntry& entry, const CObservation::Ptr& obs,
                                  size_t position) {
    Member member{&entry, position, obs, false};
    if (!loadIfExternal(member)) return;
    ++entry.unresolved;
    const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(obs.get());
    if (!scan) return reduceTurn({member});
    auto open = open_.find(obs->sensorLabel);
    if (open == open_.end()) {
        const SensorConfig config = config_.sensorOf(obs->sensorLabel);
        OpenTurn turn{TurnCollector<Member>(config), config.maxColumnPause};
        open = open_.emplace(obs->sensorLabel, std::move(turn)).first;
    }
    reduceTurns(open->second.columns.add(*scan, member));
}

const ScanClass* LogReduction::scanClassIn(const Member& member) const {
    return scanClassOf(*member.obs, config_.sensorOf(member.obs->sensorLabel));
}

/// False if it is to be copied as it is, because its file cannot be loaded.
bool LogReduction::loadIfExternal(Member& member) const {
    try {
        member.loaded = scanClassIn(member)->loadExternal(*member.obs, settings_.input);
        return true;
    } catch (const std::exception&) {
        if (!settings_.keepGoing) throw;
        onNotSupported("externally stored, and its file cannot be read");
        return false;
    }
}

void LogReduction::endOverdueTurns(mrpt::Clock::time_point now) {
    for (auto& [label, turn] : open_) {
        const std::chrono::duration<double> longest(turn.maxPause);
        if (!turn.columns.empty() && now - turn.columns.latest().obs->timestamp > longest)
            reduceTurns(turn.columns.finish());
    }
}

void LogReduction::reduceTurns(const std::vector<std::vector<Member>>& turns) {
    for (const std::vector<Member>& members : turns) reduceTurn(members);
}

void LogReduction::reduceTurn(const std::vector<Member>& members) {
    const ScanClass& scanClass = *scanClassIn(members.front());
    Turn turn;
    for (const Member& member : members) turn.push_back(member.obs);
    ReducedTurn reduced = reducer_.reduce(turn, scanClass);
    std::vector<CObservation::Ptr> removed(members.size());
    if (removed_) removed = reducer_.removedFrom(turn, reduced, scanClass);
    for (size_t i = 0; i < members.size(); ++i) {
        PendingEntry& entry = *members[i].entry;
        if (!reduced.reduced[i] && members[i].loaded) reduced.reduced[i] = members[i].obs;
        entry.replacements.push_back({members[i].position, reduced.reduced[i], removed[i]});
        --entry.unresolved;
    }
    reduced.record.entry = members.front().entry->index;
    if (reduced.vehicleInMap && !settings_.poseLabel.empty()) {
        members.front().entry->poses.push_back(
            robotPose(*reduced.vehicleInMap, reduced.record.time, settings_.poseLabel));
    }
    onTurn(reduced);
}

void LogReduction::writeReady() {
    while (!pending_.empty() && pending_.front().unresolved == 0) {
        write(pending_.front());
        pending_.pop_front();
    }
}

void LogReduction::write(const PendingEntry& entry) {
    using Poses = std::vector<CObservation::Ptr>;
    const bool frame = std::dynamic_pointer_cast<CSensoryFrame>(entry.object) != nullptr;
    const auto writeTo = [&](RawlogWriter& writer, auto member, const Poses& within) {
        const bool changes =
            !within.empty() || std::ranges::any_of(entry.replacements, [&](const Replacement& r) {
                return (r.*member) != nullptr;
            });
        if (!changes) return writer.writeBytes(entry.bytes);
        writer.write(*replaced(entry.object, entry.replacements, within,
                               [&](const Replacement& r) { return r.*member; }));
    };
    writeTo(reduced_, &Replacement::reduced, frame ? entry.poses : Poses());
    if (!frame) {
        for (const CObservation::Ptr& pose : entry.poses) reduced_.write(*pose);
    }
    if (removed_) writeTo(*removed_, &Replacement::removed, {});
}

void LogReduction::finish() {
    for (auto& [label, turn] : open_) reduceTurns(turn.columns.finish());
    writeReady();
}

}  // namespace offmap::rawlog
