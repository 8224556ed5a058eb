// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/PoseSource.h>

#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace offmap::rawlog {

/// Which poses a user wants; what is not set is left to the log.
struct PoseRequest {
    std::optional<mrpt::math::TPose2D> fixed;  ///< one vehicleInMap for the whole log
    std::filesystem::path trajectory;          ///< a file of poses; empty: none
    std::string label;  ///< of robot poses or odometry, or "actions"; empty: any
    std::optional<mrpt::math::TPose2D> initial;  ///< vehicleInMap where the log's movement begins
    double delay = 0;                            ///< [s] by which the stamps of the poses are late
};

/// What poses were made from.
enum class PoseOrigin : uint8_t { None, Fixed, Trajectory, RobotPoses, Actions, Odometry };

/// Where poses come from, and how to say so.
struct ChosenPoses {
    std::unique_ptr<PoseSource> source;  ///< never null
    std::string description;             ///< "LOCALIZATION: 1,204 robot poses"
    PoseOrigin origin = PoseOrigin::None;
    std::string warning;  ///< that the poses can hardly be meant; empty: nothing to warn of
};

/// A request that contradicts itself, or asks for what the log does not have or not only once.
class PoseRequestError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// A fixed pose or a trajectory takes the place of the log's own poses. Of those, robot poses go
/// before the movements of actions, and these before odometry, unless the label says otherwise.
/// \param log its name, for messages
/// \param mayBeMissing a log without poses is no error; every look-up then answers NoPose
/// \throw PoseRequestError if the request is wrong, std::runtime_error if there is no pose at all
ChosenPoses choosePoses(const PoseRequest& request, const Config& config, const LogSurvey& survey,
                        const std::filesystem::path& log, bool mayBeMissing);

}  // namespace offmap::rawlog
