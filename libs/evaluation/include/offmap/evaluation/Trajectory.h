// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/SensorPose.h>
#include <offmap/evaluation/Motion.h>

#include <mrpt/poses/CPose3D.h>

#include <functional>

namespace offmap::evaluation {

/// Where the sensor stands, so many seconds after the first column of a turn. [s]
using Trajectory = std::function<core::SensorPose(double seconds)>;

/// That of a sensor on a vehicle that moves. The covariance stays as it is at the start.
/// \param start of the sensor, be it the truth or an estimate
Trajectory onVehicle(const core::SensorPose& start, const Motion& motionOfVehicle,
                     const mrpt::poses::CPose3D& sensorInVehicle = {});

/// Gives every column the pose of its time: compensated movement. For a pose that is held during
/// the turn, not compensated, see setSensor().
void setTrajectory(core::OrganizedScan& scan, const Trajectory& sensor);

}  // namespace offmap::evaluation
