// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace offmap::app {

/// What the command line says; SimulationPlan is what it means.
struct SimulateOptions {
    std::string world;
    std::filesystem::path folder;
    std::string scanClass = "pointcloud";
    std::string scanner;  ///< empty: what suits the class
    uint32_t scans = 10;
    uint64_t seed = 1;
    double rangeNoise = 0.02;      ///< [m]
    double angleNoiseDegrees = 0;  ///< [deg]
    bool mixedPixels = false;
    double tiltDegrees = 0;            ///< [deg]
    double mapError = 0.01;            ///< [m]
    std::string poseSigma = "0.03,1";  ///< "m,deg"
    double statedFactor = 1;
    double speed = 0;           ///< [m/s]
    double yawRateDegrees = 0;  ///< [deg/s]
    bool noCompensation = false;
    bool force = false, quiet = false;

    void addTo(CLI::App& command);
};

}  // namespace offmap::app
