// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Instrument.h"

#include <offmap/evaluation/RandomScenes.h>
#include <offmap/evaluation/Score.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace offmap::accuracy {

/// How far the estimate of a pose is off the truth, and what it states of that.
struct Localisation {
    double sigmaHeading;   ///< [rad] of the error drawn
    double sigmaPosition;  ///< [m] of the error drawn, in x and in y
    double stated = 1;     ///< [-] the standard deviations stated, by the true ones

    /// An error that the stated covariance knows nothing of; the heading turns either way.
    struct Blunder {
        double shift;  ///< [m] in a random direction
        double turn;   ///< [rad]
    };
    std::optional<Blunder> blunder{};
    bool kidnapped = false;  ///< a random pose within the map's bounds instead
};

/// What scans are taken under.
struct Condition {
    std::string name;
    const Instrument* instrument;
    std::function<evaluation::Scene(uint64_t seed)> makeScene;
    std::vector<Localisation> localisations;  ///< that the scans take in turn
    /// Besides: ranges with a sigma of 2 cm, walls drawn 1 cm off, the scanner leaning by up to
    /// 2 degrees.
};

/// The pose before and after it was conditioned on the scan: x, y [m] and heading [rad].
struct RefinedPose {
    Eigen::Vector3d errorBefore, errorAfter;
    Eigen::Vector3d statedVariance;  ///< [m^2], [rad^2] of the prior
    Eigen::Vector3d variance;        ///< [m^2], [rad^2] of the posterior
    double squaredError;             ///< errorAfter, normalised by the posterior covariance
};

/// What a method made of one scan.
struct Outcome {
    uint64_t seed = 0;
    evaluation::Score score;
    uint64_t onSegments = 0, removedOnSegments = 0;  ///< points, mapped or not
    bool flagged = false;  ///< the scan was said not to fit the stated pose
    bool keptWhole = false;
    std::optional<RefinedPose> pose;
};
using Outcomes = std::array<Outcome, methodCount>;

/// Simulates one scan, and reduces it with every method.
/// \param scan counts the scans of this condition \param seed determines all that is random
Outcomes runTrial(const Condition& condition, size_t scan, uint64_t seed);

}  // namespace offmap::accuracy
