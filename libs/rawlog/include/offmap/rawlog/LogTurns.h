// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/LogEntry.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/ScanClass.h>
#include <offmap/rawlog/SensorConfigs.h>
#include <offmap/rawlog/TurnCollector.h>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// An observation of a turn, and where it stands.
struct TurnMember {
    std::shared_ptr<LogEntry> entry;
    size_t position = 0;  ///< in the sensory frame
    mrpt::obs::CObservation::Ptr obs;
    bool loaded = false;  ///< from a file of its own: to be written even if nothing is removed
};

/// A complete turn of a log.
struct LogTurn {
    uint64_t number = 0;  ///< of the log's turns, in the order in which they are completed
    const ScanClass* scanClass = nullptr;
    std::vector<TurnMember> members;
};

/// Some entries of a log, and the turns that they complete.
struct LogStretch {
    std::vector<std::shared_ptr<LogEntry>> entries;
    std::vector<LogTurn> turns;
    /// Of 3D observations that are copied because offmap cannot reduce them: why.
    std::vector<std::string> notSupported;
    size_t bytes = 0;  ///< [byte] of the entries
};

/// Takes one entry of a log after the other and tells what can be reduced. Memory depends on a
/// turn's length, not on the log's.
class LogTurns {
 public:
    struct Settings {
        std::filesystem::path input;    ///< externally stored clouds are looked for beside it
        std::set<std::string> sensors;  ///< labels to reduce; empty: all
        bool keepGoing = false;         ///< copy what cannot be loaded, instead of throwing
    };

    /// All references must outlive it.
    LogTurns(const LogSurvey& survey, const Config& config, Settings settings);

    /// Adds the entry, and what it completes.
    void add(const RawlogEntry& entry, LogStretch& to);
    /// Ends all open turns.
    void finish(LogStretch& to);

 private:
    struct OpenTurn {
        TurnCollector<TurnMember> columns;
        double maxPause;  ///< [s]
    };
    void addObservation(TurnMember member, LogStretch& to);
    bool loadIfExternal(TurnMember& member, LogStretch& to);
    void endOverdueTurns(mrpt::Clock::time_point now, LogStretch& to);
    void addTurns(std::vector<std::vector<TurnMember>> turns, LogStretch& to);

    const LogSurvey& survey_;
    SensorConfigs configs_;
    Settings settings_;
    std::map<std::string, OpenTurn> open_;  // by label
    uint64_t turns_ = 0;
};

}  // namespace offmap::rawlog
