// SPDX-License-Identifier: BSD-3-Clause
#include "Trial.h"

#include "Disturbed.h"

#include <offmap/core/Reducer.h>
#include <offmap/evaluation/Disturbances.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <Eigen/Dense>
#include <mrpt/math/wrap2pi.h>

namespace offmap::accuracy {

namespace {

constexpr double sigmaRange = 0.02, sigmaMap = 0.01;  // [m]

RefinedPose refinedPose(const core::Alignment& alignment, const core::SensorPose& estimate,
                        const mrpt::poses::CPose3D& truth) {
    const mrpt::poses::CPose3D& stated = estimate.sensorInMap;
    const Eigen::Matrix3d covariance = alignment.correction.covariance.topLeftCorner<3, 3>();
    RefinedPose pose;
    pose.errorBefore = {stated.x() - truth.x(), stated.y() - truth.y(),
                        mrpt::math::wrapToPi(stated.yaw() - truth.yaw())};
    pose.errorAfter = pose.errorBefore + alignment.correction.mean.head<3>();
    pose.statedVariance = estimate.groundCovariance.diagonal();
    pose.variance = covariance.diagonal();
    pose.squaredError = pose.errorAfter.dot(covariance.ldlt().solve(pose.errorAfter));
    return pose;
}

Outcome outcomeOf(const core::ReductionResult& result, const evaluation::SimulatedScan& simulated) {
    std::vector<bool> onSegment(result.labels.size());
    Outcome outcome;
    for (const core::VerticalSegment& segment : result.segments) {
        for (uint32_t i = segment.begin; i < segment.end; ++i) onSegment[i] = true;
        outcome.onSegments += segment.end - segment.begin;
    }
    for (size_t i = 0; i < result.labels.size(); ++i) {
        const evaluation::PointTruth& truth = simulated.truth[i];
        const bool removed = core::isRemoved(result.labels[i]);
        outcome.score.add({truth.mapped, onSegment[i], removed, truth.kind, truth.standOff});
        outcome.removedOnSegments += removed && onSegment[i];
    }
    outcome.keptWhole = outcome.score.mapped.removed + outcome.score.unmapped.removed == 0;
    outcome.flagged =
        result.notReduced.has_value() || (result.alignment && result.alignment->contradictsPrior());
    return outcome;
}

}  // namespace

Outcomes runTrial(const Condition& condition, size_t scan, uint64_t seed) {
    const evaluation::Scene scene = condition.makeScene(seed);
    Randomness random(seed);
    auto simulated = evaluation::simulate(scene.world, condition.instrument->scanner,
                                          leaning(scene.sensor, random), {.range = sigmaRange},
                                          random.simulation);
    const auto walls = evaluation::withMapError(mapOf(scene.world), sigmaMap, random.gaussian);
    const auto& localisation = condition.localisations[scan % condition.localisations.size()];
    const auto estimate = estimateOf(scene.sensor, localisation, walls, random);
    evaluation::setSensor(simulated.scan, estimate);

    const core::LineMap map(walls);
    Outcomes outcomes;
    for (size_t m = 0; m < methodCount; ++m) {
        core::ReductionConfig config = condition.instrument->config;
        config.matching.method = methods[m];
        core::Reducer reducer(map, config);
        const core::ReductionResult& result = reducer.reduce(simulated.scan);
        outcomes[m] = outcomeOf(result, simulated);
        outcomes[m].seed = seed;
        if (result.alignment && !result.notReduced) {
            outcomes[m].pose = refinedPose(*result.alignment, estimate, scene.sensor.sensorInMap);
        }
    }
    return outcomes;
}

}  // namespace offmap::accuracy
