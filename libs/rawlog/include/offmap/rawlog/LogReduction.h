// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/LogTurns.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/RawlogWriter.h>
#include <offmap/rawlog/StageTimes.h>
#include <offmap/rawlog/TurnReducer.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// What is told of a turn beside its figures.
struct TurnNotes {
    std::string segments;            ///< rows of a SegmentsFile
    std::vector<std::byte> picture;  ///< entry of a rawlog
};

/// The second pass over a log: reads it, reduces its turns and hands every entry on in the order it
/// came, in as many threads as TBB's arena has that it is called in. An entry waits only as long as
/// a turn that it is part of, or that stands before it, is not complete; and so much only is on its
/// way at once as keeps the threads busy: memory depends on a turn's length, not on the log's.
class LogReduction {
 public:
    struct Outputs {
        RawlogWriter& reduced;
        RawlogWriter* removed = nullptr;   ///< may be null
        RawlogWriter* pictures = nullptr;  ///< of the notes; may be null
        std::string poseLabel = {};        ///< refined poses are added under it; empty: not added
    };
    struct Work;

    /// All references must outlive it. \param makeReducer called once a thread
    /// \param times that the cost of each stage is added to
    LogReduction(const LogSurvey& survey, const Config& config, LogTurns::Settings settings,
                 std::function<TurnReducer()> makeReducer, Outputs outputs, StageTimes& times);

    /// Called before each entry is read.
    std::function<void(const EntryPlace&)> beforeEntry = [](const EntryPlace&) {};
    /// Called for each turn, in several threads at once and in any order.
    std::function<TurnNotes(uint64_t number, const ReducedTurn&, const core::ReductionResult&)>
        describe =
            [](uint64_t, const ReducedTurn&, const core::ReductionResult&) { return TurnNotes{}; };
    /// Called for each turn, in the order in which turns are completed.
    std::function<void(const TurnRecord&, const TurnNotes&)> onTurn = [](const TurnRecord&,
                                                                         const TurnNotes&) {};
    /// Called for each 3D observation that is copied because offmap cannot reduce it, with the
    /// reason.
    std::function<void(const std::string&)> onNotSupported = [](const std::string&) {};
    /// Called with the number of entries of which all is known.
    std::function<void(uint64_t)> onEntries = [](uint64_t) {};

    /// Reads as many entries as the survey has seen.
    /// \throw RawlogError, std::exception; then the outputs are of no use
    void run(RawlogReader& reader);

 private:
    using WorkPtr = std::shared_ptr<Work>;
    WorkPtr read(RawlogReader& reader);
    void reduce(Work& work, TurnReducer& reducer) const;
    void order(Work& work);
    void serialise(Work& work) const;
    void cut(Work& work) const;
    void pack(Work& work) const;
    void write(Work& work) const;

    const LogSurvey& survey_;
    std::filesystem::path input_;
    LogTurns turns_;
    std::function<TurnReducer()> makeReducer_;
    Outputs outputs_;
    StageTimes& times_;
    uint64_t entriesRead_ = 0, entriesOrdered_ = 0;
    bool ended_ = false;                             // all entries are read, all turns are ended
    std::deque<std::shared_ptr<LogEntry>> pending_;  // in order, the first not resolved
};

}  // namespace offmap::rawlog
