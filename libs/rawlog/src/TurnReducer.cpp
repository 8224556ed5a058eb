// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/RefinedPose.h>
#include <offmap/rawlog/TurnReducer.h>

#include <algorithm>
#include <utility>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using Steady = std::chrono::steady_clock;

namespace {

/// Per point, the returns that it stands for: itself and those that repeat it.
std::vector<uint64_t> returnsPerPoint(const TurnScan& turn) {
    std::vector<uint64_t> returns(turn.scan.points.size(), 1);
    for (const DuplicateReturn& duplicate : turn.duplicates) ++returns[duplicate.point];
    return returns;
}

/// Counts the returns of each segment, and those removed. \return all that were removed
uint64_t countReturns(const core::ReductionResult& result, ReducedTurn& out) {
    const std::vector<uint64_t> returns = returnsPerPoint(out.organized);
    const auto removedOf = [&](size_t i) { return isRemoved(result.labels[i]) ? returns[i] : 0; };
    for (const core::VerticalSegment& segment : result.segments) {
        uint64_t all = 0, removed = 0;
        for (uint32_t i = segment.begin; i < segment.end; ++i) {
            all += returns[i];
            removed += removedOf(i);
        }
        out.returnsPerSegment.push_back(all);
        out.removedPerSegment.push_back(removed);
    }
    uint64_t removed = 0;
    for (size_t i = 0; i < returns.size(); ++i) removed += removedOf(i);
    return removed;
}

/// Where the removed returns of a segment are counted.
uint64_t& removedFor(core::Verdict verdict, TurnRecord& record) {
    switch (verdict) {
        case core::Verdict::MappedByRay:
            return record.removedByRay;
        case core::Verdict::MappedByExtension:
            return record.removedByExtension;
        case core::Verdict::RemovedAsOrphan:
            return record.removedAsOrphans;
        case core::Verdict::Kept:
            break;
    }
    return record.removedByPoint;
}

/// Fills in what the result says; the rest of the record is known before.
void record(const core::ReductionResult& result, ReducedTurn& turn) {
    TurnRecord& out = turn.record;
    for (const core::ScanColumn& column : turn.organized.scan.columns) {
        out.columns += column.begin != column.end;
    }
    out.columnsWithoutPose = result.columnsWithoutPose;
    if (result.notReduced) out.notReduced = core::toString(*result.notReduced);
    out.health = core::healthOf(result);
    uint64_t offSegments = countReturns(result, turn);
    for (size_t s = 0; s < result.segments.size(); ++s) {
        const uint64_t removed = turn.removedPerSegment[s];
        const uint64_t kept = turn.returnsPerSegment[s] - removed;
        const core::SegmentMatch& match = result.matches[s];
        out.onVerticalSegments += turn.returnsPerSegment[s];
        removedFor(match.verdict, out) += removed;
        offSegments -= removed;
        const bool whole = match.verdict == core::Verdict::Kept;
        (whole ? out.keptByReason[static_cast<size_t>(match.reason)] : out.keptOffWall) += kept;
    }
    out.removedByPoint += offSegments;
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
    : reducer_(map, config.reduction),
      poses_(poses),
      config_(config),
      sensors_(config),
      output_(output) {
    config.validate();
}

CObservation::Ptr TurnReducer::select(const CObservation& obs, const ScanClass& scanClass,
                                      SlotMask keep, Leftovers leftovers,
                                      const SensorConfig& config) const {
    return output_ == OutputClass::Points ? scanClass.asPointCloud(obs, keep, config)
                                          : scanClass.withOnly(obs, keep, leftovers);
}

ReducedTurn TurnReducer::reduce(const Turn& turn, const ScanClass& scanClass) {
    begin(scanClass);
    return finish(turn);
}

void TurnReducer::begin(const ScanClass& scanClass) {
    scanClass_ = &scanClass;
    columns_.reset();
    spent_ = {};
}

TurnColumns& TurnReducer::columns(const Turn& turn) {
    if (!columns_ || !columns_->hold()) {
        reducer_.begin();
        columns_ = std::make_unique<TurnColumns>(*scanClass_, poses_,
                                                 sensors_.of(turn.front()->sensorLabel),
                                                 config_.reduction.alignment.sigmaRange);
    }
    return *columns_;
}

void TurnReducer::add(const Turn& soFar) {
    const auto begin = Steady::now();
    columns(soFar).add(soFar);
    reducer_.add(columns_->scan());
    spent_ += Steady::now() - begin;
}

ReducedTurn TurnReducer::finish(const Turn& turn) {
    const auto begin = Steady::now();
    columns(turn).finish(turn);
    result_ = &reducer_.finish(columns_->scan());
    ReducedTurn out;
    out.organized = std::move(*columns_).take();
    columns_.reset();
    takeOut(turn, out);
    spent_ += Steady::now() - begin;

    out.record.milliseconds = std::chrono::duration<double, std::milli>(spent_).count();
    out.record.counts = out.organized.counts;
    out.record.time = turn.front()->timestamp;
    out.record.label = turn.front()->sensorLabel;
    out.record.className = classNameOf(*turn.front());
    record(*result_, out);
    out.vehicleInMap = refinedPose(out.organized.scan, *result_, poses_, out.record.time);
    return out;
}

/// Makes the reduced observations of what the result says.
void TurnReducer::takeOut(const Turn& turn, ReducedTurn& out) {
    const SensorConfig& config = sensors_.of(turn.front()->sensorLabel);
    size_t slots = 0;
    for (const auto& obs : turn) slots += scanClass_->slotCount(*obs);
    out.removedSlots = removedSlots(out.organized, *result_, slots);
    std::vector<uint8_t> keep(out.removedSlots);
    for (uint8_t& slot : keep) slot = !slot;
    size_t first = 0;
    for (const auto& obs : turn) {
        const SlotMask own = SlotMask(keep).subspan(first, scanClass_->slotCount(*obs));
        first += own.size();
        const bool allStay = std::ranges::find(own, 0) == own.end();
        const bool unchanged = output_ == OutputClass::Same && allStay;
        out.reduced.push_back(unchanged ? nullptr
                                        : select(*obs, *scanClass_, own, Leftovers::Keep, config));
    }
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
