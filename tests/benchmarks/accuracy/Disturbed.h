// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trial.h"

#include <offmap/core/LineMap.h>
#include <offmap/evaluation/GaussianNoise.h>
#include <offmap/evaluation/UniformNumbers.h>

#include <vector>

namespace offmap::accuracy {

/// What is random about a trial besides its scene.
struct Randomness {
    explicit Randomness(uint64_t seed);
    evaluation::UniformNumbers uniform;
    evaluation::GaussianNoise gaussian;
    uint64_t simulation;  ///< seed of what the beams measure
};

/// The pose leaning by up to 2 degrees in any direction.
core::SensorPose leaning(const core::SensorPose& upright, Randomness& random);

/// What the localisation says of a sensor that truly stands there.
core::SensorPose estimateOf(const core::SensorPose& truth, const Localisation& localisation,
                            const std::vector<core::Wall>& walls, Randomness& random);

}  // namespace offmap::accuracy
