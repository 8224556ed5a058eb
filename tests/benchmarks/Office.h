// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/SensorPose.h>
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/SimulatedScan.h>

namespace offmap::test {

/// The office room with 2 cm of range noise, seen from where the pose says: that is known to 3 cm
/// and 0.5 degrees.
struct Office {
    explicit Office(const evaluation::Scanner& scanner) {
        pose.sensorInMap.setFromValues(2, 2.5, 1.1);
        pose.groundCovariance = Eigen::Vector3d(9e-4, 9e-4, 7.6e-5).asDiagonal();
        scan = evaluation::simulate(world, scanner, pose, {.range = 0.02}, 1).scan;
    }
    evaluation::World world = evaluation::officeRoom();
    core::LineMap map{mapOf(world)};
    core::SensorPose pose;
    core::OrganizedScan scan;
};

}  // namespace offmap::test
