// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ByProcessor.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/RefinedPose.h>
#include <offmap/rawlog/TurnReducer.h>

#include <algorithm>
#include <utility>

namespace offmap::rawlog {

using mrpt::obs::CObservation;
using Steady = std::chrono::steady_clock;

namespace {

OFFMAP_BY_PROCESSOR uint32_t countRemoved(std::span<const core::PointLabel> labels) {
    uint32_t removed = 0;
    for (const core::PointLabel label : labels) removed += core::isRemoved(label);
    return removed;
}

/// Counts the returns of each segment, and those removed: its points, and what repeats them.
/// \return all that were removed
uint64_t countReturns(const core::ReductionResult& result, ReducedTurn& out) {
    const std::span<const core::PointLabel> labels = result.labels;
    for (const core::VerticalSegment& segment : result.segments) {
        const auto own = labels.subspan(segment.begin, segment.end - segment.begin);
        out.returnsPerSegment.push_back(own.size());
        out.removedPerSegment.push_back(countRemoved(own));
    }
    uint64_t removed = countRemoved(labels);
    for (const DuplicateReturn& duplicate : out.organized.duplicates) {
        const bool isRemoved = core::isRemoved(labels[duplicate.point]);
        removed += isRemoved;
        const auto behind = std::ranges::upper_bound(result.segments, duplicate.point, {},
                                                     &core::VerticalSegment::begin);
        if (behind == result.segments.begin() || std::prev(behind)->end <= duplicate.point)
            continue;
        const auto s = static_cast<size_t>(std::prev(behind) - result.segments.begin());
        ++out.returnsPerSegment[s];
        out.removedPerSegment[s] += isRemoved;
    }
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

/// Marks what is removed of one column. Mostly, its slots are numbered on: then in one go.
OFFMAP_BY_PROCESSOR void markRemoved(const uint32_t* slots, const core::PointLabel* labels,
                                     uint32_t count, uint8_t* removed) {
    uint32_t elsewhere = 0;
    for (uint32_t i = 0; i < count; ++i) elsewhere += slots[i] != slots[0] + i;
    if (elsewhere == 0) {
        uint8_t* __restrict ofColumn = removed + slots[0];
        for (uint32_t i = 0; i < count; ++i) ofColumn[i] = core::isRemoved(labels[i]);
        return;
    }
    for (uint32_t i = 0; i < count; ++i) removed[slots[i]] = core::isRemoved(labels[i]);
}

std::vector<uint8_t> removedSlots(const TurnScan& turn, const core::ReductionResult& result,
                                  size_t slots) {
    std::vector<uint8_t> removed(slots, 0);
    for (const core::ScanColumn& column : turn.scan.columns) {
        if (column.begin == column.end) continue;
        markRemoved(turn.scan.sourceIndex.data() + column.begin,
                    result.labels.data() + column.begin, column.end - column.begin, removed.data());
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
