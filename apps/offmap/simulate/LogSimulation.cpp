// SPDX-License-Identifier: BSD-3-Clause
#include "LogSimulation.h"

#include "RotatingRows.h"

#include <offmap/evaluation/GaussianNoise.h>
#include <offmap/rawlog/LidarModels.h>

#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace offmap::app {

namespace {

using mrpt::math::TPose2D;
using mrpt::poses::CPose3D;
using TimePoint = mrpt::Clock::time_point;

mrpt::Clock::duration seconds(double s) {
    return std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::duration<double>(s));
}

/// 2023-11-14 22:13:20 UTC, and on from there at half a metre a second.
TimePoint startOf(const SimulationPlan& plan, size_t place) {
    constexpr double driveDuration = 1;  // [s] from the end of a scan to the next
    const double period = plan.sensor.scanner.turnDuration + driveDuration;
    return mrpt::Clock::fromDouble(1.7e9) + seconds(static_cast<double>(place) * period);
}

evaluation::SimulatedScan scanAt(const SimulationPlan& plan, size_t place) {
    const auto sensor = [&](double late) -> core::SensorPose {
        const TPose2D vehicle = moved(plan.places[place], plan.motion, late);
        return {.sensorInMap = CPose3D(vehicle) + plan.mounting};
    };
    auto scan = evaluation::simulateMoving(plan.scene.world, plan.sensor.scanner, sensor,
                                           plan.noise, seedOf(plan.seed, Draw::Scan, place));
    const auto late = startOf(plan, place) - TimePoint();
    for (core::ScanColumn& column : scan.scan.columns) column.time += late;
    return scan;
}

/// What a localisation says of the vehicle during one scan: off by an error that stays.
class Localisation {
 public:
    Localisation(const SimulationPlan& plan, size_t place) : plan_(plan), place_(place) {
        evaluation::GaussianNoise noise(seedOf(plan.seed, Draw::Pose, place));
        error_ = {noise.next(plan.sigmaPosition), noise.next(plan.sigmaPosition),
                  noise.next(plan.sigmaHeading)};
    }

    /// \param late [s] from the start of the scan
    mrpt::obs::CObservation::Ptr after(double late) const {
        const double known = plan_.posesFollow ? late : 0;
        const TPose2D truth = moved(plan_.places[place_], plan_.motion, known);
        auto obs = mrpt::obs::CObservationRobotPose::Create();
        obs->sensorLabel = "LOCALIZATION";
        obs->timestamp = startOf(plan_, place_) + seconds(late);
        obs->pose.mean = CPose3D(TPose2D(truth.x + error_.x, truth.y + error_.y,
                                         mrpt::math::wrapToPi(truth.phi + error_.phi)));
        const double position = plan_.statedFactor * plan_.sigmaPosition;
        const double heading = plan_.statedFactor * plan_.sigmaHeading;
        obs->pose.cov.setZero();
        obs->pose.cov(0, 0) = obs->pose.cov(1, 1) = position * position;
        obs->pose.cov(3, 3) = heading * heading;
        return obs;
    }

 private:
    const SimulationPlan& plan_;
    size_t place_;
    TPose2D error_;  // [m], [rad] in the map's axes
};

}  // namespace

rawlog::SensorConfig sensorConfigOf(const LogSensor& sensor) {
    rawlog::SensorConfig config;
    if (rawlog::elevationsOfModel(rotatingModel(sensor.scanner)).empty()) {
        config.elevations = sensor.scanner.elevations;
    }
    return config;
}

LoggedTurn simulateTurn(const SimulationPlan& plan, size_t place) {
    const evaluation::SimulatedScan scan = scanAt(plan, place);
    const auto encoded = plan.encoder(scan, plan.sensor);
    LoggedTurn turn;
    turn.truth = truthOf(scan, encoded, sensorConfigOf(plan.sensor), place);

    const Localisation localisation(plan, place);
    constexpr double posePeriod = 0.1;  // [s] at most
    const double duration = plan.sensor.scanner.turnDuration;
    const double intervals = std::ceil(duration / posePeriod);
    for (double i = 0; i < intervals; ++i) {
        turn.entries.push_back(localisation.after(i / intervals * duration));
    }
    turn.entries.push_back(localisation.after(duration));
    for (const EncodedObservation& one : encoded) turn.entries.push_back(one.observation);
    std::ranges::stable_sort(turn.entries, {}, [](const auto& entry) { return entry->timestamp; });
    return turn;
}

}  // namespace offmap::app
