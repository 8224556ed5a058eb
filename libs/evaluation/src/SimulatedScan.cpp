// SPDX-License-Identifier: BSD-3-Clause
#include "Beams.h"

#include <offmap/evaluation/SimulatedScan.h>

#include <Eigen/Eigenvalues>

#include <chrono>

namespace offmap::evaluation {

namespace {

mrpt::Clock::duration timeOf(const Scanner& scanner, size_t column) {
    const double share = static_cast<double>(column) / static_cast<double>(scanner.azimuths.size());
    const std::chrono::duration<double> sinceStart(share * scanner.turnDuration);
    return std::chrono::duration_cast<mrpt::Clock::duration>(sinceStart);
}

}  // namespace

SimulatedScan simulate(const World& world, const Scanner& scanner, const core::SensorPose& sensor,
                       const ScannerNoise& noise, uint64_t seed) {
    return simulateMoving(
        world, scanner, [&sensor](double /*seconds*/) { return sensor; }, noise, seed);
}

SimulatedScan simulateMoving(const World& world, const Scanner& scanner, const Trajectory& sensor,
                             const ScannerNoise& noise, uint64_t seed) {
    Beams beams(world, scanner, noise, seed);
    SimulatedScan result;
    uint32_t beamIndex = 0;
    for (size_t c = 0; c < scanner.azimuths.size(); ++c) {
        core::ScanColumn column;
        const mrpt::Clock::duration late = timeOf(scanner, c);
        column.time = mrpt::Clock::time_point{} + late;
        column.sensor = sensor(std::chrono::duration<double>(late).count());
        beams.fireFrom(column.sensor->sensorInMap);
        column.begin = static_cast<uint32_t>(result.scan.points.size());
        for (size_t ring = 0; ring < scanner.elevations.size(); ++ring) {
            beams.fire(beamAngles(scanner, c, ring), beamIndex++, result);
        }
        column.end = static_cast<uint32_t>(result.scan.points.size());
        column.azimuth = static_cast<float>(scanner.azimuths[c]);
        result.scan.columns.push_back(std::move(column));
    }
    return result;
}

void setSensor(core::OrganizedScan& scan, const core::SensorPose& sensor) {
    for (core::ScanColumn& column : scan.columns) column.sensor = sensor;
}

core::SensorPose drawEstimate(const core::SensorPose& truth, GaussianNoise& noise) {
    // A square root by eigenvalues, since a covariance of rank < 3 has no Cholesky factor.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(truth.groundCovariance);
    Eigen::Vector3d independent;
    for (double& x : independent) x = noise.next();
    const Eigen::Vector3d error =
        solver.eigenvectors() *
        solver.eigenvalues().cwiseMax(0).cwiseSqrt().cwiseProduct(independent);

    core::SensorPose estimate = truth;
    estimate.sensorInMap = mrpt::poses::CPose3D(0, 0, 0, error[2], 0, 0) + truth.sensorInMap;
    estimate.sensorInMap.x(truth.sensorInMap.x() + error[0]);
    estimate.sensorInMap.y(truth.sensorInMap.y() + error[1]);
    return estimate;
}

}  // namespace offmap::evaluation
