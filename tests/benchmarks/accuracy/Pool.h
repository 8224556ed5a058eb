// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trial.h"

#include <span>

namespace offmap::accuracy {

/// Errors of refined poses, over many scans.
struct PosePool {
    size_t scans = 0;
    Eigen::Vector3d squaresBefore = Eigen::Vector3d::Zero();  ///< sums [m^2], [m^2], [rad^2]
    Eigen::Vector3d squaresAfter = Eigen::Vector3d::Zero();
    Eigen::Vector3d statedVariances = Eigen::Vector3d::Zero();
    Eigen::Vector3d variances = Eigen::Vector3d::Zero();
    double squaredErrors = 0;  ///< [-] sum of the normalised ones
    size_t beyond95 = 0;       ///< scans whose normalised squared error an honest one in 20 exceeds

    void add(const RefinedPose& pose);
    void add(const PosePool& more);
    double meanSquaredError() const;  ///< [-] 3 if the covariance is honest
};

/// One scan, to find the worst ones by. The seed makes it again, see runTrial().
struct ScanFigures {
    std::string condition;
    uint64_t seed;
    double mappedRemoved;    ///< [0, 1] of the mapped points on vertical segments
    double unmappedRemoved;  ///< [0, 1]
    double squaredError;     ///< [-] of the refined pose, normalised; 0 without one
    bool flagged;
};

/// What one method made of the scans of a condition.
struct Pool {
    evaluation::PooledScore score;
    uint64_t points = 0, onSegments = 0, removedOnSegments = 0;
    size_t flagged = 0, keptWhole = 0;  ///< scans
    PosePool pose;
    std::vector<ScanFigures> scans;

    void add(const Outcome& outcome, const std::string& condition);
    void add(const Pool& more);
    double flaggedShare() const;    ///< [0, 1] of the scans
    double keptWholeShare() const;  ///< [0, 1] of the scans
};
using Pools = std::array<Pool, methodCount>;

/// Runs so many scans of every condition, on so many threads; the result does not depend on these.
std::vector<Pools> run(std::span<const Condition* const> conditions, size_t scans, uint64_t seed,
                       unsigned threads);

/// All pools in one, method by method.
Pools poolOf(std::span<const Pools> parts);

}  // namespace offmap::accuracy
