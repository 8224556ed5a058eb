// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/Motion.h>
#include <offmap/evaluation/World.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace offmap::evaluation {

/// A robot's way through a world, on which it takes scans.
struct DrivePlan {
    mrpt::math::TPose2D start;  ///< [m], [rad] the first place
    size_t places = 1;
    double step = 0.5;          ///< [m] from the end of a scan to the next place
    Motion whileScanning = {};  ///< at each place, from there on
    double scanDuration = 0;    ///< [s]
};

/// Places where the scans begin. The robot goes straight on with slight turns, and turns away from
/// what stands before it; its middle keeps 0.3 m from all surfaces up to 1.8 m height, on its way
/// and while it scans, and stays within the map's bounds. Where it cannot go on, it turns on the
/// spot.
/// \throw std::runtime_error if there is no room for the movement during a scan
std::vector<mrpt::math::TPose2D> placesOnDrive(const World& world, const DrivePlan& plan,
                                               uint64_t seed);

}  // namespace offmap::evaluation
