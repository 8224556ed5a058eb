// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/SelfMask.h>
#include <offmap/rawlog/TurnReducer.h>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace offmap::rawlog {

using mrpt::obs::CObservation;

namespace {

/// Returns on each segment: its points, and those that repeat them.
std::vector<uint64_t> returnsPerSegment(const TurnScan& turn, const core::ReductionResult& result) {
    std::vector<uint64_t> returns;
    for (const auto& segment : result.segments) returns.push_back(segment.end - segment.begin);
    if (turn.duplicates.empty()) return returns;
    std::vector<uint32_t> copies(turn.scan.points.size(), 0);
    for (const DuplicateReturn& duplicate : turn.duplicates) ++copies[duplicate.point];
    for (size_t s = 0; s < returns.size(); ++s) {
        const core::VerticalSegment& segment = result.segments[s];
        returns[s] += std::accumulate(copies.begin() + segment.begin, copies.begin() + segment.end,
                                      uint64_t{0});
    }
    return returns;
}

/// Fills in what the result says; the rest of the record is known before.
void record(const TurnScan& turn, const std::vector<uint64_t>& returns,
            const core::ReductionResult& result, TurnRecord& out) {
    for (const core::ScanColumn& column : turn.scan.columns) {
        out.columns += column.begin != column.end;
    }
    out.columnsWithoutPose = result.columnsWithoutPose;
    if (result.notReduced) out.notReduced = core::toString(*result.notReduced);
    for (size_t s = 0; s < returns.size(); ++s) {
        out.onVerticalSegments += returns[s];
        switch (result.matches[s].verdict) {
            case core::Verdict::MappedByRay:
                out.removedByRay += returns[s];
                break;
            case core::Verdict::MappedByExtension:
                out.removedByExtension += returns[s];
                break;
            case core::Verdict::RemovedAsOrphan:
                out.removedAsOrphans += returns[s];
                break;
            case core::Verdict::Kept:
                out.keptByReason[static_cast<size_t>(result.matches[s].reason)] += returns[s];
                break;
        }
    }
}

std::vector<uint8_t> removedSlots(const TurnScan& turn, const core::ReductionResult& result,
                                  size_t slots) {
    std::vector<uint8_t> removed(slots, 0);
    for (size_t i = 0; i < result.labels.size(); ++i) {
        removed[turn.scan.sourceIndex[i]] = core::isRemoved(result.labels[i]);
    }
    for (const DuplicateReturn& duplicate : turn.duplicates) {
        removed[duplicate.slot] = removed[turn.scan.sourceIndex[duplicate.point]];
    }
    return removed;
}

}  // namespace

TurnReducer::TurnReducer(const core::LineMap& map, const PoseSource& poses, const Config& config,
                         OutputClass output)
    : reducer_(map, config.reduction), poses_(poses), config_(config), output_(output) {
    config.validate();
}

const SensorConfig& TurnReducer::sensorOf(const std::string& label) {
    const auto known = sensors_.find(label);
    if (known != sensors_.end()) return known->second;
    return sensors_.emplace(label, config_.sensorOf(label)).first->second;
}

CObservation::Ptr TurnReducer::select(const CObservation& obs, const ScanClass& scanClass,
                                      SlotMask keep, Leftovers leftovers,
                                      const SensorConfig& config) const {
    return output_ == OutputClass::Points ? scanClass.asPointCloud(obs, keep, config)
                                          : scanClass.withOnly(obs, keep, leftovers);
}

ReducedTurn TurnReducer::reduce(const Turn& turn, const ScanClass& scanClass) {
    const auto begin = std::chrono::steady_clock::now();
    ReducedTurn out;
    size_t slots = 0;
    for (const auto& obs : turn) slots += scanClass.slotCount(*obs);
    const SensorConfig& config = sensorOf(turn.front()->sensorLabel);
    out.organized = scanClass.organize(turn, poses_, config);
    maskSelfReturns(out.organized, config);
    result_ = &reducer_.reduce(out.organized.scan);
    out.removedSlots = removedSlots(out.organized, *result_, slots);

    std::vector<uint8_t> keep(out.removedSlots);
    for (uint8_t& slot : keep) slot = !slot;
    size_t first = 0;
    for (const auto& obs : turn) {
        const SlotMask own = SlotMask(keep).subspan(first, scanClass.slotCount(*obs));
        first += own.size();
        const bool unchanged = output_ == OutputClass::Same && std::ranges::count(own, 0) == 0;
        out.reduced.push_back(unchanged ? nullptr
                                        : select(*obs, scanClass, own, Leftovers::Keep, config));
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;

    out.record.milliseconds = took.count();
    out.record.counts = out.organized.counts;
    out.record.time = turn.front()->timestamp;
    out.record.label = turn.front()->sensorLabel;
    out.record.className = classNameOf(*turn.front());
    out.returnsPerSegment = returnsPerSegment(out.organized, *result_);
    record(out.organized, out.returnsPerSegment, *result_, out.record);
    return out;
}

std::vector<CObservation::Ptr> TurnReducer::removedFrom(const Turn& turn,
                                                        const ReducedTurn& reduced,
                                                        const ScanClass& scanClass) const {
    const SensorConfig config = config_.sensorOf(turn.front()->sensorLabel);
    std::vector<CObservation::Ptr> removed;
    size_t first = 0;
    for (const auto& obs : turn) {
        const SlotMask own =
            SlotMask(reduced.removedSlots).subspan(first, scanClass.slotCount(*obs));
        first += own.size();
        removed.push_back(select(*obs, scanClass, own, Leftovers::Drop, config));
    }
    return removed;
}

}  // namespace offmap::rawlog
