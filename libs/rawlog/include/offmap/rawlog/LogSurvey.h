// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/MotionStep.h>
#include <offmap/rawlog/PoseTrack.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/SweepTurns.h>

#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace offmap::rawlog {

/// The first and the last of some times.
struct TimeSpan {
    mrpt::Clock::time_point begin, end;
};

/// A span that also holds `time`.
TimeSpan spanned(const std::optional<TimeSpan>& span, mrpt::Clock::time_point time);

/// What one sensor label of a log holds.
struct SensorSurvey {
    std::string className;  ///< of its first observation
    uint64_t observations = 0;
    SweepDetector sweep;            ///< of 2D scans: is it a scanner that turns about the vertical?
    bool scans3d = false;           ///< whether it can be reduced
    std::optional<TimeSpan> times;  ///< of the observations that have a time
    /// Why its first 3D observation that cannot be reduced cannot.
    std::optional<std::string> unsupported;
};

/// Where the wheels say that the vehicle is, since they began to count.
struct StampedOdometry {
    mrpt::Clock::time_point time;
    mrpt::math::TPose2D vehicleInOdometry;  ///< [m], [rad]
};

/// What the actions of a log tell, and the sensory frames that they lead to.
struct ActionSurvey {
    uint64_t collections = 0;  ///< CActionCollection
    uint64_t frames = 0;       ///< CSensoryFrame
    uint64_t movements = 0;    ///< collections that tell a movement
    /// In the order of the log: the movements, and without one the frames that follow no movement.
    std::vector<MotionStep> steps;
};

/// What has to be known of a log before its first scan can be reduced: the poses, which 2D scanners
/// turn, and whether it can be read to its end.
struct LogSurvey {
    uint64_t entries = 0;                                   ///< that can be read
    std::map<std::string, SensorSurvey> sensors;            ///< by label
    std::map<std::string, std::vector<StampedPose>> poses;  ///< by label, in the order of the log
    std::map<std::string, std::vector<StampedOdometry>> odometry;  ///< alike; those with a time
    ActionSurvey actions;
    std::optional<RawlogError> damage;  ///< where reading ended too early

    bool holdsScans() const;
    /// Of all sensors that can be reduced; none if they tell no time.
    std::optional<TimeSpan> scanTimes() const;
    /// Whether offmap knows how to reduce this observation. \param config of its sensor
    bool reducible(const mrpt::obs::CObservation& obs, const SensorConfig& config) const;
};

/// Reads a log once, up to maxEntries. \param onEntry called before each entry is read
LogSurvey surveyLog(RawlogReader& reader, const Config& config, uint64_t maxEntries,
                    const std::function<void()>& onEntry);

}  // namespace offmap::rawlog
