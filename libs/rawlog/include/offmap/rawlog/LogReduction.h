// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/RawlogWriter.h>
#include <offmap/rawlog/TurnCollector.h>
#include <offmap/rawlog/TurnReducer.h>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/serialization/CSerializable.h>

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// The second pass over a log: takes one entry after the other, reduces what it completes, and
/// hands every entry on in the order it came. An entry waits only as long as a turn that it is part
/// of, or that stands before it, is not complete; so memory depends on a turn's length, not on the
/// log's.
class LogReduction {
 public:
    struct Settings {
        std::filesystem::path input;    ///< externally stored clouds are looked for beside it
        std::set<std::string> sensors;  ///< labels to reduce; empty: all
        bool keepGoing = false;         ///< copy what cannot be loaded, instead of throwing
        std::string poseLabel;          ///< refined poses are added under it; empty: not added
    };

    /// All references must outlive it. \param removed may be null
    LogReduction(const LogSurvey& survey, TurnReducer& reducer, const Config& config,
                 Settings settings, RawlogWriter& reduced, RawlogWriter* removed);

    /// Called for each turn, in the order in which turns are completed; the reducer's result() is
    /// that of the turn.
    std::function<void(const ReducedTurn&)> onTurn = [](const ReducedTurn&) {};
    /// Called for each 3D observation that is copied because offmap cannot reduce it, with the
    /// reason.
    std::function<void(const std::string&)> onNotSupported = [](const std::string&) {};

    void add(const RawlogEntry& entry);
    /// Ends all open turns and writes what is left.
    void finish();

 private:
    /// What an observation of an entry becomes.
    struct Replacement {
        size_t position;                       // in the sensory frame
        mrpt::obs::CObservation::Ptr reduced;  // null: as it was
        mrpt::obs::CObservation::Ptr removed;  // null: as it was
    };
    struct PendingEntry {
        uint64_t index;
        std::vector<std::byte> bytes;
        mrpt::serialization::CSerializable::Ptr object;
        std::vector<Replacement> replacements;
        // Refined, of turns that begin here: to be written behind it, or as a frame's last members.
        std::vector<mrpt::obs::CObservation::Ptr> poses;
        size_t unresolved = 0;  // observations whose turn is not complete
    };
    struct Member {
        PendingEntry* entry;
        size_t position;
        mrpt::obs::CObservation::Ptr obs;
        bool loaded;  // from a file of its own: to be written even if nothing is removed
    };
    const ScanClass* scanClassIn(const Member& member) const;
    bool loadIfExternal(Member& member) const;
    void addObservation(PendingEntry& entry, const mrpt::obs::CObservation::Ptr& obs,
                        size_t position);
    void endOverdueTurns(mrpt::Clock::time_point now);
    void reduceTurns(const std::vector<std::vector<Member>>& turns);
    void reduceTurn(const std::vector<Member>& members);
    void writeReady();
    void write(const PendingEntry& entry);

    const LogSurvey& survey_;
    TurnReducer& reducer_;
    const Config& config_;
    Settings settings_;
    RawlogWriter& reduced_;
    RawlogWriter* removed_;
    std::deque<PendingEntry> pending_;
    struct OpenTurn {
        TurnCollector<Member> columns;
        double maxPause;  // [s]
    };
    std::map<std::string, OpenTurn> open_;  // by label
};

}  // namespace offmap::rawlog
