// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionConfig.h>
#include <offmap/evaluation/RandomScenes.h>
#include <offmap/evaluation/Scanner.h>

#include <cstdint>
#include <string>
#include <vector>

namespace offmap::profit {

/// A scanner, what its users set, and how near to each other it sees the points of one thing.
struct Instrument {
    std::string name;
    evaluation::Scanner scanner;
    core::ReductionConfig config;
    float tolerance;  ///< [m] of the clustering
};

/// What the clustering made of clouds.
struct Clustered {
    uint64_t points = 0;  ///< that were clustered
    uint64_t clusters = 0;
    uint64_t objectsFound = 0;  ///< that have a cluster of their own
    double milliseconds = 0;    ///< [ms] of the processor

    void add(const Clustered& more);
};

/// Figures of scans, summed.
struct Profit {
    uint64_t scans = 0;
    uint64_t objects = 0;  ///< not on the map, with points enough for a cluster
    Clustered full, reduced;
    double reductionMilliseconds = 0;  ///< [ms] of the processor, to take the mapped points out

    void add(const Profit& more);
};

/// Fewer points are no cluster.
inline constexpr size_t minPoints = 10;
/// [m] Points nearer to floor or ceiling are left out before the clustering, of both clouds.
inline constexpr double floorMargin = 0.1;
/// Of the scan and of the pose, which is stated as it was drawn.
inline constexpr double sigmaRange = 0.02;     ///< [m]
inline constexpr double sigmaPosition = 0.03;  ///< [m]
inline constexpr double sigmaHeadingDegrees = 0.5;

/// Scans a scene, reduces the scan, and clusters both. \param seed of the noise
Profit profitOf(const evaluation::Scene& scene, const Instrument& instrument, uint64_t seed);

}  // namespace offmap::profit
