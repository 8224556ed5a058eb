// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceOutputs.h"

#include <offmap/rawlog/Serialised.h>
#include <offmap/view/InspectionScene.h>

#include <mrpt/obs/CObservation3DScene.h>

namespace offmap::app {

namespace {

mrpt::obs::CObservation3DScene::Ptr pictureOf(const rawlog::ReducedTurn& turn,
                                              const core::ReductionResult& result,
                                              const core::LineMap& map) {
    auto picture = mrpt::obs::CObservation3DScene::Create();
    picture->timestamp = turn.record.time;
    picture->scene = view::inspectionSceneOf(turn.organized.scan, result, map);
    return picture;
}

}  // namespace

ReduceOutputs::ReduceOutputs(const ReduceFiles& files, const ReduceOptions& options,
                             rawlog::GuardedStatus& status)
    : status_(status) {
    const rawlog::OutputOptions compressed{options.compression, options.force, &status};
    const rawlog::OutputOptions plain{std::nullopt, options.force, &status};
    reduced_.emplace(files.output, compressed);
    if (!files.removed.empty()) removed_.emplace(files.removed, compressed);
    if (!files.inspect.empty()) inspect_.emplace(files.inspect, compressed);
    if (!files.report.empty()) report_.emplace(files.report, plain);
    if (!files.segments.empty()) segments_.emplace(files.segments, plain);
}

void ReduceOutputs::begin(const nlohmann::ordered_json& head) {
    if (report_) report_->begin(head);
}

rawlog::LogReduction::Outputs ReduceOutputs::logs() {
    return {*reduced_, removed_ ? &*removed_ : nullptr, inspect_ ? &*inspect_ : nullptr};
}

rawlog::TurnNotes ReduceOutputs::notesOf(uint64_t number, const rawlog::ReducedTurn& turn,
                                         const core::ReductionResult& result,
                                         const core::LineMap& map) const {
    rawlog::TurnNotes notes;
    if (segments_) notes.segments = rawlog::SegmentsFile::rowsOf(number, turn, result);
    if (inspect_) rawlog::serialise(*pictureOf(turn, result, map), notes.picture);
    return notes;
}

void ReduceOutputs::add(const rawlog::TurnRecord& turn, const rawlog::TurnNotes& notes) {
    if (report_) report_->add(turn);
    if (segments_) segments_->add(notes.segments);
}

void ReduceOutputs::finish(const rawlog::ReductionTotals& totals,
                           const nlohmann::ordered_json& tail) {
    reduced_->finish();
    if (removed_) removed_->finish();
    if (inspect_) inspect_->finish();
    if (report_) report_->finish(totals, tail);
    if (segments_) segments_->finish();
}

void ReduceOutputs::publish() {
    status_.beginPublishing();
    if (removed_) removed_->publish();
    if (inspect_) inspect_->publish();
    if (report_) report_->publish();
    if (segments_) segments_->publish();
    reduced_->publish();  // last: where it is, the others are
}

}  // namespace offmap::app
