// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPose3D.h>

#include <map>
#include <string>
#include <vector>

namespace offmap::app {

/// The poses that --sensor-pose gives, by label. \param texts
/// "LABEL=x,y,z,yaw_deg,pitch_deg,roll_deg"; the label reaches to the last equals sign
/// \throw UsageError for one of another form, and for a label that stands there twice
std::map<std::string, mrpt::math::TPose3D> parseSensorPoses(const std::vector<std::string>& texts);

/// "x,y,z,yaw_deg,pitch_deg,roll_deg"
std::string sensorPoseText(const mrpt::math::TPose3D& pose);

}  // namespace offmap::app
