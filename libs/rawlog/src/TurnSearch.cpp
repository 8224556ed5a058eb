// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/TurnAssembler.h>
#include <offmap/rawlog/TurnSearch.h>

#include <mrpt/obs/CObservation2DRangeScan.h>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;

std::optional<Turn> findTurn(RawlogReader& reader, const LogSurvey& survey, const Config& config,
                             uint64_t entry, const std::filesystem::path& input,
                             const std::function<void()>& onEntry) {
    TurnAssembler assembler(config, input);
    expectSweepsOf(survey, assembler);
    std::optional<Turn> found;
    const auto take = [&](const std::vector<PlacedTurn>& turns) {
        for (const PlacedTurn& turn : turns) {
            if (!found && turn.lastEntry >= entry) found = turn.turn;
        }
    };
    for (uint64_t index = 0; index < survey.entries && !found; ++index) {
        onEntry();
        const auto next = reader.next();
        if (!next) break;
        forEachObservation(next->object, [&](const CObservation::Ptr& obs, size_t) {
            const bool isColumn = dynamic_cast<const CObservation2DRangeScan*>(obs.get());
            if (found || (index < entry && !isColumn)) return;
            if (survey.reducible(*obs, config.sensorOf(obs->sensorLabel)))
                take(assembler.add(obs, index));
        });
    }
    take(assembler.finish());
    return found;
}

void expectSweepsOf(const LogSurvey& survey, TurnAssembler& assembler) {
    for (const auto& [label, sensor] : survey.sensors) {
        if (sensor.sweep.isSweep()) assembler.expectSweeps(label);
    }
}

}  // namespace offmap::rawlog
