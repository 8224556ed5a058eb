// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "EncodedScan.h"
#include "SimulateOptions.h"

#include <offmap/evaluation/Motion.h>
#include <offmap/evaluation/RandomScenes.h>

#include <mrpt/math/TPose2D.h>

#include <string>
#include <vector>

namespace offmap::app {

/// What is to be simulated.
struct SimulationPlan {
    evaluation::Scene scene;
    std::vector<core::Wall> map;    ///< the walls as the map shows them
    LogSensor sensor;               ///< as the log tells of it
    mrpt::poses::CPose3D mounting;  ///< sensor in vehicle, as it truly is
    Encoder encoder = nullptr;
    evaluation::ScannerNoise noise;
    evaluation::Motion motion;  ///< while it scans
    bool posesFollow = true;    ///< the log's poses tell the movement during a scan
    double sigmaPosition = 0;   ///< [m] of the log's poses, in x and in y
    double sigmaHeading = 0;    ///< [rad]
    double statedFactor = 1;    ///< what the log states is so many times as large
    uint64_t seed = 1;
    std::vector<mrpt::math::TPose2D> places;  ///< of the vehicle, where the scans begin
};

/// \throw UsageError for what cannot be meant
SimulationPlan planOf(const SimulateOptions& options);

/// A seed for each of the things that are random, as independent as those of a generator.
enum class Draw : uint64_t { Map, Tilt, Drive, Pose, Scan };
uint64_t seedOf(uint64_t seed, Draw draw, uint64_t index = 0);

}  // namespace offmap::app
