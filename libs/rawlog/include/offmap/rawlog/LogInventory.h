// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/VerticalSegments.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/IntervalMedian.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/PoseCoverage.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/ScanClass.h>
#include <offmap/rawlog/SensorConfigs.h>
#include <offmap/rawlog/SensorModel.h>
#include <offmap/rawlog/TurnCollector.h>

#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace offmap::rawlog {

/// What a log holds of one class under one label.
struct SensorInventory {
    SensorModel model;  ///< of the first observation
    uint64_t observations = 0;
    std::optional<TimeSpan> span;  ///< of those with a valid time
    IntervalMedian interval;
    std::optional<mrpt::poses::CPose3D> mounting;  ///< of the first observation
    bool mountingVaries = false;

    bool scans3d = false;             ///< holds 3D scans, whether or not they can be reduced
    uint64_t reducible = 0;           ///< observations
    uint64_t scans = 0;               ///< turns made of those
    ReturnCounts counts;              ///< of those
    uint64_t onVerticalSegments = 0;  ///< points; only these can be removed
    std::map<std::string, uint64_t> notReducible;  ///< 3D observations by reason
    uint64_t external = 0;                         ///< observations with files of their own
    uint64_t externalMissing = 0;                  ///< of those; the file cannot be read
    std::string externalProblem;                   ///< what was wrong with the first one
};

/// How many of the log's entries are what.
struct EntryCounts {
    uint64_t observations = 0;  ///< that are entries of their own
    uint64_t actionCollections = 0;
    uint64_t sensoryFrames = 0;
    uint64_t nothing = 0;                     ///< null pointers
    std::map<std::string, uint64_t> actions;  ///< in the collections, by class
    uint64_t withoutTime = 0;                 ///< observations without a valid time, wherever
};

/// The second pass over a log for those who want to know what it holds: takes one entry after the
/// other. Memory depends on the length of a turn and the number of labels, not on the log's length.
class LogInventory {
 public:
    using Sensor = std::pair<std::string, std::string>;  ///< label, class

    /// All references must outlive it. \param input externally stored files are looked for beside
    /// it \param coverages are told of each 3D observation of the sensors with these labels; empty:
    /// of all
    LogInventory(const LogSurvey& survey, const Config& config, std::filesystem::path input,
                 std::set<std::string> sensors, std::vector<PoseCoverage*> coverages);

    void add(const RawlogEntry& entry);
    /// Ends all open turns.
    void finish();

    const std::map<Sensor, SensorInventory>& sensors() const { return sensors_; }
    const EntryCounts& entries() const { return entries_; }
    const std::optional<TimeSpan>& span() const { return span_; }          ///< of the log
    const std::optional<TimeSpan>& scanSpan() const { return scanSpan_; }  ///< of 3D observations

 private:
    void addObservation(const mrpt::obs::CObservation::Ptr& obs);
    void addScan(SensorInventory& sensor, const mrpt::obs::CObservation::Ptr& obs,
                 const SensorConfig& config);
    void countTurn(SensorInventory& sensor, const Turn& turn, const SensorConfig& config);

    const LogSurvey& survey_;
    std::filesystem::path input_;
    std::set<std::string> chosen_;
    std::vector<PoseCoverage*> coverages_;
    std::map<Sensor, SensorInventory> sensors_;
    EntryCounts entries_;
    std::optional<TimeSpan> span_, scanSpan_;
    SensorConfigs configs_;
    core::LevelledScan levelled_;
    core::VerticalSegmentFinder finder_;
    std::vector<core::VerticalSegment> segments_;
    std::map<Sensor, TurnCollector<mrpt::obs::CObservation::ConstPtr>> open_;
};

}  // namespace offmap::rawlog
