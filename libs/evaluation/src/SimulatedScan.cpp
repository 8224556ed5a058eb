// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SimulatedScan.h>
#include <offmap/evaluation/StandOff.h>

#include <Eigen/Eigenvalues>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

TVector3D beam(double azimuth, double elevation) {
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

/// Fires single beams.
class Beams {
 public:
    Beams(const World& world, const Scanner& scanner, const ScannerNoise& noise, uint64_t seed)
        : world_(world), scanner_(scanner), noise_(noise), random_(seed) {
        for (uint32_t id = 0; id < world.surfaces().size(); ++id) truths_.push_back(truthOf(id));
    }

    void fireFrom(const mrpt::poses::CPose3D& sensorInMap) { sensorInMap_ = sensorInMap; }

    /// Adds the return, if there is one. The beam leaves off its direction by the noise of the
    /// angles; its point is put where the beam should have gone.
    void fire(const BeamAngles& angles, uint32_t sourceIndex, SimulatedScan& result) {
        const double trueAzimuth = angles.azimuth + random_.next(noise_.angle);
        const double trueElevation = angles.elevation + random_.next(noise_.angle);
        const double rangeError = random_.next(noise_.range);

        const auto direction = sensorInMap_.rotateVector(beam(trueAzimuth, trueElevation));
        const auto hit = world_.castRay(sensorInMap_.translation(), direction, scanner_.maxRange);
        if (!hit || hit->range + rangeError <= 0) return;

        const TPoint3D point = beam(angles.azimuth, angles.elevation) * (hit->range + rangeError);
        result.scan.points.push_back(point.cast<float>());
        result.scan.sourceIndex.push_back(sourceIndex);
        result.truth.push_back(truths_[hit->surface]);
    }

 private:
    PointTruth truthOf(uint32_t id) const {
        const Surface& surface = world_.surfaces()[id];
        PointTruth truth{id, surface.kind, surface.mapped()};
        if (const auto gap = standOffOf(world_, id)) truth.standOff = static_cast<float>(*gap);
        return truth;
    }

    const World& world_;
    const Scanner& scanner_;
    const ScannerNoise& noise_;
    mrpt::poses::CPose3D sensorInMap_;
    GaussianNoise random_;
    std::vector<PointTruth> truths_;  ///< one per surface
};

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
    if (!(noise.range >= 0 && noise.angle >= 0)) {
        throw std::invalid_argument("the standard deviations of the noise must be >= 0");
    }
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
