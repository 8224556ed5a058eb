// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnCollector.h>
#include <offmap/rawlog/TurnSearch.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <map>
#include <string>

namespace offmap::rawlog {

using mrpt::obs::CObservation;

namespace {

struct Column {
    CObservation::ConstPtr scan;
    uint64_t entry;
};

/// The turn, if it reaches to the entry.
std::optional<Turn> reaching(const std::vector<Column>& columns, uint64_t entry) {
    if (columns.back().entry < entry) return std::nullopt;
    Turn turn;
    for (const Column& column : columns) turn.push_back(column.scan);
    return turn;
}

}  // namespace

std::optional<Turn> findTurn(RawlogReader& reader, const LogSurvey& survey, const Config& config,
                             uint64_t entry, const std::filesystem::path& input,
                             const std::function<void()>& onEntry) {
    std::map<std::string, TurnCollector<Column>> open;  // by label
    std::optional<Turn> found;
    const auto take = [&](const std::vector<std::vector<Column>>& turns) {
        for (const auto& columns : turns) {
            if (!found) found = reaching(columns, entry);
        }
    };
    const auto look = [&](const CObservation::Ptr& obs, uint64_t index) {
        if (found) return;
        const SensorConfig own = config.sensorOf(obs->sensorLabel);
        if (!survey.reducible(*obs, own)) return;
        const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(obs.get());
        if (scan) {
            auto& turn = open.try_emplace(obs->sensorLabel, own).first->second;
            take(turn.add(*scan, {obs, index}));
        } else if (index >= entry) {
            scanClassOf(*obs, own)->loadExternal(*obs, input);
            found = Turn{obs};
        }
    };
    for (uint64_t index = 0; index < survey.entries && !found; ++index) {
        onEntry();
        const auto next = reader.next();
        if (!next) break;
        forEachObservation(next->object,
                           [&](const CObservation::Ptr& obs, size_t) { look(obs, index); });
    }
    for (auto& [label, turn] : open) take(turn.finish());
    return found;
}

}  // namespace offmap::rawlog
