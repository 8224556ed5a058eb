// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Trajectory.h>

#include <chrono>

namespace offmap::evaluation {

using mrpt::math::TPose2D;
using mrpt::poses::CPose3D;

Trajectory onVehicle(const core::SensorPose& start, const Motion& motionOfVehicle,
                     const CPose3D& sensorInVehicle) {
    const CPose3D vehicle = start.sensorInMap + (-sensorInVehicle);
    const TPose2D from(vehicle.x(), vehicle.y(), vehicle.yaw());
    return [start, motionOfVehicle, from](double seconds) {
        // turns and shifts all that stands on the vehicle, in the map
        const TPose2D to = moved(from, motionOfVehicle, seconds);
        core::SensorPose sensor = start;
        sensor.sensorInMap = CPose3D(to) + (-CPose3D(from)) + start.sensorInMap;
        return sensor;
    };
}

void setTrajectory(core::OrganizedScan& scan, const Trajectory& sensor) {
    for (core::ScanColumn& column : scan.columns) {
        const std::chrono::duration<double> late = column.time - scan.columns.front().time;
        column.sensor = sensor(late.count());
    }
}

}  // namespace offmap::evaluation
