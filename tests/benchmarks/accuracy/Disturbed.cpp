// SPDX-License-Identifier: BSD-3-Clause
#include "Disturbed.h"

#include <offmap/evaluation/Disturbances.h>
#include <offmap/evaluation/SimulatedScan.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <numbers>

namespace offmap::accuracy {

namespace {

using mrpt::math::TPoint2D;
using mrpt::poses::CPose3D;

/// SplitMix64: seeds next to each other, and the scene's own, would give related numbers.
uint64_t mixed(uint64_t seed, uint64_t stream) {
    uint64_t z = seed + (stream + 1) * 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

double anyDirection(Randomness& random) {
    return random.uniform.between(-std::numbers::pi, std::numbers::pi);
}

CPose3D anywhere(double z, const std::vector<core::Wall>& walls, Randomness& random) {
    TPoint2D low = walls.front().line.point1, high = low;
    for (const core::Wall& wall : walls) {
        for (const TPoint2D& end : {wall.line.point1, wall.line.point2}) {
            low = {std::min(low.x, end.x), std::min(low.y, end.y)};
            high = {std::max(high.x, end.x), std::max(high.y, end.y)};
        }
    }
    const double x = random.uniform.between(low.x, high.x);
    const double y = random.uniform.between(low.y, high.y);
    return {x, y, z, anyDirection(random), 0, 0};
}

}  // namespace

Randomness::Randomness(uint64_t seed)
    : uniform(mixed(seed, 0)), gaussian(mixed(seed, 1)), simulation(mixed(seed, 2)) {}

core::SensorPose leaning(const core::SensorPose& upright, Randomness& random) {
    const double tilt = random.uniform.between(0, mrpt::DEG2RAD(2.0));
    return evaluation::tilted(upright, tilt, anyDirection(random));
}

core::SensorPose estimateOf(const core::SensorPose& truth, const Localisation& localisation,
                            const std::vector<core::Wall>& walls, Randomness& random) {
    core::SensorPose known = truth;
    const double position = localisation.sigmaPosition, heading = localisation.sigmaHeading;
    known.groundCovariance =
        Eigen::Vector3d(position * position, position * position, heading * heading).asDiagonal();
    if (localisation.kidnapped) {
        known.sensorInMap = anywhere(truth.sensorInMap.z(), walls, random);
        return known;
    }
    if (const auto& blunder = localisation.blunder) {
        const double turn = random.uniform.chance(0.5) ? blunder->turn : -blunder->turn;
        return evaluation::misplaced(known, blunder->shift, anyDirection(random), turn);
    }
    return evaluation::withStatedSigma(evaluation::drawEstimate(known, random.gaussian),
                                       localisation.stated);
}

}  // namespace offmap::accuracy
