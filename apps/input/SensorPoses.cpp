// SPDX-License-Identifier: BSD-3-Clause
#include "SensorPoses.h"

#include "NumberList.h"
#include "UsageError.h"

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

namespace offmap::app {

using mrpt::DEG2RAD;
using mrpt::RAD2DEG;
using mrpt::math::TPose3D;

namespace {

constexpr const char* form = "x,y,z,yaw_deg,pitch_deg,roll_deg";

}  // namespace

std::map<std::string, TPose3D> parseSensorPoses(const std::vector<std::string>& texts) {
    std::map<std::string, TPose3D> poses;
    for (const std::string& text : texts) {
        const size_t equals = text.rfind('=');
        if (equals == std::string::npos) {
            throw UsageError(
                fmt::format("--sensor-pose is '{}', but must be LABEL={}", text, form));
        }
        const std::string label = text.substr(0, equals);
        const auto n = parseNumbers(text.substr(equals + 1),
                                    fmt::format("--sensor-pose of '{}'", label), form);
        const TPose3D pose(n[0], n[1], n[2], DEG2RAD(n[3]), DEG2RAD(n[4]), DEG2RAD(n[5]));
        if (!poses.emplace(label, pose).second) {
            throw UsageError(fmt::format("--sensor-pose gives '{}' a second pose", label));
        }
    }
    return poses;
}

std::string sensorPoseText(const TPose3D& pose) {
    return fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}", pose.x, pose.y, pose.z,
                       RAD2DEG(pose.yaw), RAD2DEG(pose.pitch), RAD2DEG(pose.roll));
}

}  // namespace offmap::app
