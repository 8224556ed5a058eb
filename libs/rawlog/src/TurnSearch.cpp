// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/SweepTurns.h>
#include <offmap/rawlog/TurnSearch.h>

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <map>
#include <string>

namespace offmap::rawlog {

using mrpt::obs::CObservation;

namespace {

struct OpenTurn {
    SweepTurns turns;
    Turn columns;
    uint64_t lastEntry = 0;
};

}  // namespace

std::optional<Turn> findTurn(RawlogReader& reader, const LogSurvey& survey,
                             const SensorConfig& config, uint64_t entry,
                             const std::filesystem::path& input,
                             const std::function<void()>& onEntry) {
    std::map<std::string, OpenTurn> open;
    std::optional<Turn> found;
    const auto look = [&](const CObservation::Ptr& obs, uint64_t index) {
        if (found || !survey.reducible(*obs)) return;
        const auto* scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(obs.get());
        if (!scan) {
            if (index < entry) return;
            auto* cloud = dynamic_cast<mrpt::obs::CObservationPointCloud*>(obs.get());
            if (cloud) loadExternal(*cloud, input);
            found = Turn{obs};
            return;
        }
        OpenTurn& turn =
            open.try_emplace(obs->sensorLabel, OpenTurn{SweepTurns(config), {}, 0}).first->second;
        if (turn.turns.startsNewTurn(*scan)) {
            if (!turn.columns.empty() && turn.lastEntry >= entry) found = std::move(turn.columns);
            turn.columns.clear();
        }
        turn.columns.push_back(obs);
        turn.lastEntry = index;
    };
    for (uint64_t index = 0; index < survey.entries && !found; ++index) {
        onEntry();
        const auto next = reader.next();
        if (!next) break;
        forEachObservation(next->object,
                           [&](const CObservation::Ptr& obs, size_t) { look(obs, index); });
    }
    for (auto& [label, turn] : open) {
        if (!found && !turn.columns.empty() && turn.lastEntry >= entry)
            found = std::move(turn.columns);
    }
    return found;
}

}  // namespace offmap::rawlog
