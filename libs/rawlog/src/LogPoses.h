// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/PoseChoice.h>

#include <mrpt/math/TPose2D.h>

#include <string>
#include <vector>

namespace offmap::rawlog {

/// One of the things in a log that poses can be had from.
struct LogPoses {
    PoseOrigin origin = PoseOrigin::None;  ///< RobotPoses, Actions or Odometry
    std::string name;                      ///< the label; "actions"
    uint64_t count = 0;                    ///< of poses, movements or readings

    /// Movements tell where the vehicle is once it is known where they began.
    bool needsInitialPose() const { return origin != PoseOrigin::RobotPoses; }
    /// "LOCALIZATION: 1,204 robot poses"
    std::string describe() const;
};

/// What a log offers, what goes first in front.
std::vector<LogPoses> posesOffered(const LogSurvey& survey);

/// \param initialInMap where movements began; robot poses do not need it
std::vector<StampedPose> posesOf(const LogPoses& offered, const LogSurvey& survey,
                                 const Config& config, const mrpt::math::TPose2D& initialInMap);

}  // namespace offmap::rawlog
