// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnAssembler.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <utility>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;

TurnAssembler::TurnAssembler(const Config& config, std::filesystem::path log)
    : config_(config), log_(std::move(log)) {}

bool TurnAssembler::isSweep(const CObservation2DRangeScan& scan) {
    bool& known = sweeps_.try_emplace(scan.sensorLabel, false).first->second;
    if (known) return true;
    SweepDetector& detector = detectors_[scan.sensorLabel];
    detector.see(scan);
    return known = detector.isSweep();
}

std::vector<PlacedTurn> TurnAssembler::add(const CObservation::Ptr& obs, uint64_t entry) {
    const SensorConfig own = config_.sensorOf(obs->sensorLabel);
    const ScanClass* scanClass = scanClassOf(*obs, own);
    if (!scanClass) return {};
    const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(obs.get());
    if (!scan) {
        scanClass->loadExternal(*obs, log_);
        return {{Turn{obs}, entry, entry}};
    }
    if (!isSweep(*scan)) return {};
    auto& turn = open_.try_emplace(obs->sensorLabel, own).first->second;
    return placed(turn.add(*scan, {obs, entry}));
}

std::vector<PlacedTurn> TurnAssembler::finish() {
    std::vector<PlacedTurn> all;
    for (auto& [label, turn] : open_) {
        for (PlacedTurn& last : placed(turn.finish())) all.push_back(std::move(last));
    }
    return all;
}

std::vector<PlacedTurn> TurnAssembler::placed(const std::vector<std::vector<Column>>& turns) {
    std::vector<PlacedTurn> all;
    for (const auto& columns : turns) {
        PlacedTurn& turn = all.emplace_back();
        turn.firstEntry = columns.front().entry;
        turn.lastEntry = columns.back().entry;
        for (const Column& column : columns) turn.turn.push_back(column.scan);
    }
    return all;
}

}  // namespace offmap::rawlog
