// SPDX-License-Identifier: BSD-3-Clause
#include "Beams.h"

#include <offmap/evaluation/StandOff.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

/// Echoes of a pulse of 10 ns that come from no further apart than this melt into one. [m]
constexpr double pulseLength = 1.5;

TVector3D directionOf(const BeamAngles& angles) {
    const double level = std::cos(angles.elevation);
    return {level * std::cos(angles.azimuth), level * std::sin(angles.azimuth),
            std::sin(angles.elevation)};
}

void requireUsable(const ScannerNoise& noise) {
    if (!(noise.range >= 0 && noise.angle >= 0 && noise.dark >= 0)) {
        throw std::invalid_argument("the standard deviations of the noise must be >= 0");
    }
    if (!(noise.beamWidth >= 0 && noise.beamWidth < std::numbers::pi)) {
        throw std::invalid_argument("the width of a beam must be in [0, pi)");
    }
    if (!(noise.mixing >= 0 && noise.mixing <= 1)) {
        throw std::invalid_argument("the share of mixed returns must be in [0, 1]");
    }
}

PointTruth truthOf(const World& world, uint32_t id) {
    const Surface& surface = world.surfaces()[id];
    PointTruth truth{id, surface.kind, surface.mapped()};
    if (const auto gap = standOffOf(world, id)) truth.standOff = static_cast<float>(*gap);
    return truth;
}

}  // namespace

Beams::Beams(const World& world, const Scanner& scanner, const ScannerNoise& noise, uint64_t seed)
    : world_(world),
      scanner_(scanner),
      noise_(noise),
      random_(seed),
      darkness_(~seed),
      footprint_(~seed ^ 1) {
    requireUsable(noise);
    for (uint32_t id = 0; id < world.surfaces().size(); ++id) {
        truths_.push_back(truthOf(world, id));
    }
}

float Beams::intensityOf(const WorldHit& hit, const TVector3D& direction) const {
    const TPoint3D point = sensorInMap_.translation() + direction * hit.range;
    const Surface& surface = world_.surfaces()[hit.surface];
    const TVector3D normal =
        std::visit([&](const auto& shape) { return normalAt(shape, point); }, surface.shape);
    const double cosine = normal.x * direction.x + normal.y * direction.y + normal.z * direction.z;
    return static_cast<float>(surface.reflectivity * std::min(1.0, std::abs(cosine)));
}

std::optional<double> Beams::mixedRange(const WorldHit& hit, const BeamAngles& angles) {
    // one ray through the round footprint, evenly distributed, stands for all
    const double fromAxis = 0.5 * noise_.beamWidth * std::sqrt(footprint_.between(0, 1));
    const double around = footprint_.between(-std::numbers::pi, std::numbers::pi);
    const double share = footprint_.between(0, 1);
    const bool mixes = footprint_.chance(noise_.mixing);
    const double aside = fromAxis * std::cos(around) / std::cos(angles.elevation);
    const auto direction = sensorInMap_.rotateVector(
        directionOf({angles.azimuth + aside, angles.elevation + fromAxis * std::sin(around)}));
    const auto other = world_.castRay(sensorInMap_.translation(), direction, scanner_.maxRange);
    if (!mixes || !other || other->surface == hit.surface) return std::nullopt;
    const double gap = other->range - hit.range;
    if (std::abs(gap) > pulseLength) return std::nullopt;
    return hit.range + share * gap;
}

void Beams::fire(const BeamAngles& angles, uint32_t sourceIndex, SimulatedScan& result) {
    const double azimuth = angles.azimuth + random_.next(noise_.angle);
    const double elevation = angles.elevation + random_.next(noise_.angle);
    double rangeError = random_.next(noise_.range);

    const TVector3D meant = directionOf(angles);
    const BeamAngles axis{azimuth, elevation};
    const auto direction = sensorInMap_.rotateVector(noise_.angle > 0 ? directionOf(axis) : meant);
    const auto hit = world_.castRay(sensorInMap_.translation(), direction, scanner_.maxRange);
    if (!hit) return;
    PointTruth truth = truths_[hit->surface];
    truth.intensity = intensityOf(*hit, direction);
    if (noise_.dark > 0) {
        rangeError += darkness_.next(noise_.dark * (1 - static_cast<double>(truth.intensity)));
    }
    double range = hit->range;
    if (noise_.beamWidth > 0) {
        const auto mixed = mixedRange(*hit, axis);
        truth.mixed = mixed.has_value();
        range = mixed.value_or(range);
    }
    if (range + rangeError <= 0) return;
    result.scan.points.push_back((meant * (range + rangeError)).cast<float>());
    result.scan.sourceIndex.push_back(sourceIndex);
    result.truth.push_back(truth);
}

}  // namespace offmap::evaluation
