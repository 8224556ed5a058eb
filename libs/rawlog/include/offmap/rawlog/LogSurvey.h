// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/PoseTrack.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/SweepTurns.h>

#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// What one sensor label of a log holds.
struct SensorSurvey {
    std::string className;  ///< of its first observation
    uint64_t observations = 0;
    SweepDetector sweep;   ///< of 2D scans: is it a scanner that turns about the vertical?
    bool scans3d = false;  ///< whether it can be reduced
};

/// What has to be known of a log before its first scan can be reduced: the poses, which 2D scanners
/// turn, and whether it can be read to its end.
struct LogSurvey {
    uint64_t entries = 0;                                   ///< that can be read
    std::map<std::string, SensorSurvey> sensors;            ///< by label
    std::map<std::string, std::vector<StampedPose>> poses;  ///< by label, in the order of the log
    std::optional<RawlogError> damage;                      ///< where reading ended too early

    bool holdsScans() const;
    /// Whether offmap knows how to reduce this observation. \param config of its sensor
    bool reducible(const mrpt::obs::CObservation& obs, const SensorConfig& config) const;
};

/// Reads a log once, up to maxEntries. \param onEntry called before each entry is read
LogSurvey surveyLog(RawlogReader& reader, const Config& config, uint64_t maxEntries,
                    const std::function<void()>& onEntry);

}  // namespace offmap::rawlog
