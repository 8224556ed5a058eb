// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/SensorPose.h>
#include <offmap/evaluation/GaussianNoise.h>
#include <offmap/evaluation/Scanner.h>
#include <offmap/evaluation/Trajectory.h>
#include <offmap/evaluation/World.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace offmap::evaluation {

/// Standard deviations of what a beam measures, each independent of every other, and its width.
struct ScannerNoise {
    double range = 0;  ///< [m]
    double angle = 0;  ///< [rad] of azimuth and of elevation
    /// [m] of range besides, of a return of intensity 0; that of others is 1 - intensity times this
    double dark = 0;
    double beamWidth = 0;  ///< [rad] of the round footprint, from edge to edge
    /// Share of the beams that meet two surfaces within 1.5 m which return from somewhere between:
    /// mixed pixels. Nothing mixes while the beams have no width.
    double mixing = 1;
};

/// What a return truly comes from.
struct PointTruth {
    uint32_t surface;  ///< its id in the world
    SurfaceKind kind;
    bool mapped;
    std::optional<float> standOff{};  ///< [m] of an object from the nearest wall, see standOffOf()
    float intensity = 0;  ///< reflectivity times cosine of the incidence, [0, 1], without noise
    /// Whether it lies between its surface, which the middle of the beam meets, and another one.
    bool mixed = false;
};

struct SimulatedScan {
    core::OrganizedScan scan;       ///< sourceIndex counts all beams, column by column
    std::vector<PointTruth> truth;  ///< one per point
};

/// One turn of a standing scanner, mounted upright at the vehicle's origin.
/// \param sensor where it truly stands; the columns carry it as their pose. To give them another,
/// see setSensor().
/// \throw std::invalid_argument if a term of the noise is out of its range
SimulatedScan simulate(const World& world, const Scanner& scanner, const core::SensorPose& sensor,
                       const ScannerNoise& noise, uint64_t seed);

/// One turn of a scanner on the move; column by column it stands where the trajectory says. The
/// columns carry that as their pose.
/// \throw std::invalid_argument if a term of the noise is out of its range
SimulatedScan simulateMoving(const World& world, const Scanner& scanner, const Trajectory& sensor,
                             const ScannerNoise& noise, uint64_t seed);

/// Gives every column this pose.
void setSensor(core::OrganizedScan& scan, const core::SensorPose& sensor);

/// What a localisation of this covariance might say: the covariance of the result, and a mean that
/// is off the truth by an error drawn from it.
core::SensorPose drawEstimate(const core::SensorPose& truth, GaussianNoise& noise);

}  // namespace offmap::evaluation
