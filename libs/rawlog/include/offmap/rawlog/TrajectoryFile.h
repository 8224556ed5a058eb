// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/PoseTrack.h>

#include <filesystem>
#include <vector>

namespace offmap::rawlog {

/// Reads poses of the vehicle in the map from a text file, one a line, by time: of TUM, `t x y z qx
/// qy qz qw`, or of MRPT's CPose3DInterpolator, `t x y z yaw pitch roll`. Times are UNIX seconds,
/// lengths metres, angles radians. Blanks, commas or semicolons separate; `#` starts a comment.
/// \param sigmaPosition standard deviation of x and of y [m]
/// \param sigmaHeading standard deviation of the heading [rad]
/// \throw std::runtime_error naming file, line and what is wrong
std::vector<StampedPose> readTrajectory(const std::filesystem::path& file, double sigmaPosition,
                                        double sigmaHeading);

}  // namespace offmap::rawlog
