// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/LogReduction.h>
#include <offmap/rawlog/RefinedPose.h>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#include <stdexcept>
#include <utility>

namespace offmap::rawlog {

using mrpt::obs::CObservation;

namespace {

using Bytes = std::vector<std::byte>;

/// What became of a turn.
struct TurnOutcome {
    TurnRecord record;
    TurnNotes notes;
    std::vector<Replacement> replacements;  // one a member
    CObservation::Ptr pose;                 // null: none to be written
};

// Entries small and many, such as poses, share the cost of being handed on.
constexpr size_t stretchSize = 1 << 16;  // [byte]

}  // namespace

/// What goes from stage to stage: a stretch of the log; then entries that are ready, which may have
/// been read long before; then, for each output, their bytes and the blocks that these complete.
struct LogReduction::Work {
    LogStretch stretch;
    std::vector<TurnOutcome> outcomes;  // one a turn
    std::vector<std::shared_ptr<LogEntry>> ready;
    Bytes reduced, removed, pictures;
    std::vector<std::pair<OutputFile*, Bytes>> blocks;
};

LogReduction::LogReduction(const LogSurvey& survey, const Config& config,
                           LogTurns::Settings settings, std::function<TurnReducer()> makeReducer,
                           Outputs outputs, StageTimes& times)
    : survey_(survey),
      input_(settings.input),
      turns_(survey, config, std::move(settings)),
      makeReducer_(std::move(makeReducer)),
      outputs_(std::move(outputs)),
      times_(times) {}

void LogReduction::run(RawlogReader& reader) {
    using tbb::filter_mode;
    tbb::enumerable_thread_specific<TurnReducer> reducers(makeReducer_);
    const auto stage = [this](filter_mode mode, StageTimes::Stage name, auto&& work) {
        return tbb::make_filter<WorkPtr, WorkPtr>(mode, [this, name, work](const WorkPtr& of) {
            const StageTimes::Measure measure(times_, name);
            work(*of);
            return of;
        });
    };
    constexpr auto inOrder = filter_mode::serial_in_order, inAnyOrder = filter_mode::parallel;
    const auto threads = static_cast<size_t>(tbb::this_task_arena::max_concurrency());
    const auto readNext = [&](tbb::flow_control& flow) {
        const StageTimes::Measure measure(times_, StageTimes::Read);
        WorkPtr work = read(reader);
        if (!work) flow.stop();
        return work;
    };
    tbb::parallel_pipeline(
        2 * threads,
        tbb::make_filter<void, WorkPtr>(inOrder, readNext) &
            stage(inAnyOrder, StageTimes::Reduce,
                  [&](Work& work) { reduce(work, reducers.local()); }) &
            stage(inOrder, StageTimes::Order, [&](Work& work) { order(work); }) &
            stage(inAnyOrder, StageTimes::Serialise, [&](Work& work) { serialise(work); }) &
            stage(inOrder, StageTimes::Cut, [&](Work& work) { cut(work); }) &
            stage(inAnyOrder, StageTimes::Pack, [&](Work& work) { pack(work); }) &
            stage(inOrder, StageTimes::Write, [&](Work& work) { write(work); }) &
            tbb::make_filter<WorkPtr, void>(inAnyOrder, [](const WorkPtr&) {}));
}

/// Null at the end.
LogReduction::WorkPtr LogReduction::read(RawlogReader& reader) {
    if (ended_) return nullptr;
    auto work = std::make_shared<Work>();
    LogStretch& stretch = work->stretch;
    while (stretch.turns.empty() && stretch.bytes < stretchSize && entriesRead_ < survey_.entries) {
        beforeEntry(reader.place());
        const auto entry = reader.next();
        if (!entry) throw std::runtime_error(input_.string() + " became shorter while it was read");
        turns_.add(*entry, stretch);
        ++entriesRead_;
    }
    ended_ = entriesRead_ == survey_.entries;
    if (ended_) turns_.finish(stretch);
    return work;
}

void LogReduction::reduce(Work& work, TurnReducer& reducer) const {
    for (const LogTurn& logTurn : work.stretch.turns) {
        Turn turn;
        for (const TurnMember& member : logTurn.members) turn.push_back(member.obs);
        ReducedTurn reduced = reducer.reduce(turn, *logTurn.scanClass);
        reduced.record.entry = logTurn.members.front().entry->index;
        std::vector<CObservation::Ptr> removed(turn.size());
        if (outputs_.removed) removed = reducer.removedFrom(turn, reduced, *logTurn.scanClass);
        TurnOutcome& outcome = work.outcomes.emplace_back();
        for (size_t i = 0; i < turn.size(); ++i) {
            const TurnMember& member = logTurn.members[i];
            if (!reduced.reduced[i] && member.loaded) reduced.reduced[i] = member.obs;
            outcome.replacements.push_back({member.position, reduced.reduced[i], removed[i]});
        }
        outcome.notes = describe(logTurn.number, reduced, reducer.result());
        if (reduced.vehicleInMap && !outputs_.poseLabel.empty()) {
            outcome.pose =
                robotPose(*reduced.vehicleInMap, reduced.record.time, outputs_.poseLabel);
        }
        outcome.record = std::move(reduced.record);
    }
}

void LogReduction::order(Work& work) {
    LogStretch& stretch = work.stretch;
    pending_.insert(pending_.end(), stretch.entries.begin(), stretch.entries.end());
    for (size_t t = 0; t < stretch.turns.size(); ++t) {
        const std::vector<TurnMember>& members = stretch.turns[t].members;
        TurnOutcome& outcome = work.outcomes[t];
        for (size_t i = 0; i < members.size(); ++i) {
            members[i].entry->replacements.push_back(std::move(outcome.replacements[i]));
            --members[i].entry->unresolved;
        }
        if (outcome.pose) members.front().entry->poses.push_back(outcome.pose);
        const Bytes& picture = outcome.notes.picture;
        work.pictures.insert(work.pictures.end(), picture.begin(), picture.end());
        onTurn(outcome.record, outcome.notes);
    }
    for (const std::string& reason : stretch.notSupported) onNotSupported(reason);
    entriesOrdered_ += stretch.entries.size();
    onEntries(entriesOrdered_);
    for (; !pending_.empty() && pending_.front()->unresolved == 0; pending_.pop_front()) {
        work.ready.push_back(std::move(pending_.front()));
    }
    stretch = {};
    work.outcomes.clear();
}

void LogReduction::serialise(Work& work) const {
    for (const auto& entry : work.ready) {
        appendReduced(*entry, work.reduced);
        if (outputs_.removed) appendRemoved(*entry, work.removed);
    }
    work.ready.clear();
}

void LogReduction::cut(Work& work) const {
    const auto blocksOf = [&](RawlogWriter* writer, Bytes& bytes) {
        if (!writer) return;
        OutputFile& file = writer->file();
        for (Bytes& block : file.cut(bytes)) work.blocks.emplace_back(&file, std::move(block));
        bytes = {};
    };
    blocksOf(&outputs_.reduced, work.reduced);
    blocksOf(outputs_.removed, work.removed);
    blocksOf(outputs_.pictures, work.pictures);
}

void LogReduction::pack(Work& work) const {
    for (auto& [file, block] : work.blocks) block = file->packed(block);
}

void LogReduction::write(Work& work) const {
    for (const auto& [file, packed] : work.blocks) file->append(packed);
}

}  // namespace offmap::rawlog
