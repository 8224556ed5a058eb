// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateOptions.h"

#include "input/NumberList.h"

#include <offmap/evaluation/NamedScenes.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

namespace offmap::app {

namespace {

/// A check of CLI11 for a finite number. CLI::Range lets NaN pass.
auto between(double low, double high) {
    return [low, high](const std::string& text) {
        double number = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        if (error == std::errc() && stop == end && number >= low && number <= high) {
            return std::string();
        }
        return fmt::format("'{}' is no number from {} to {}", text, low, high);
    };
}

/// CLI11 takes -1 for the largest number.
std::string notNegative(const std::string& text) {
    return text.starts_with('-') ? fmt::format("'{}' is negative", text) : "";
}

CLI::Option* addNumber(CLI::App& command, const char* name, double& value, double low, double high,
                       const char* text) {
    return command.add_option(name, value, text)->check(between(low, high));
}

void addSensor(CLI::App& command, SimulateOptions& options) {
    command
        .add_option("--class", options.scanClass,
                    "Class of the observations (pointcloud); velodyne: packets of a VLP-16, sweep: "
                    "a 2D scanner that turns, rangeimage: a depth camera")
        ->check(CLI::IsMember({"pointcloud", "velodyne", "rotating", "sweep", "rangeimage"})
                    .description(""))
        ->type_name("pointcloud|velodyne|rotating|sweep|rangeimage");
    command
        .add_option("--scanner", options.scanner,
                    "181 x 181 beams of the paper, a VLP-16, or 2048 x 128 (paper)")
        ->check(CLI::IsMember({"paper", "vlp16", "dense"}).description(""))
        ->type_name("paper|vlp16|dense");
}

void addNoise(CLI::App& command, SimulateOptions& options) {
    addNumber(command, "--range-noise", options.rangeNoise, 0, 1,
              "Standard deviation of a range (0.02)")
        ->type_name("M");
    addNumber(command, "--angle-noise", options.angleNoiseDegrees, 0, 5,
              "Standard deviation of a beam's direction (0)")
        ->type_name("DEG");
    command.add_flag("--mixed-pixels", options.mixedPixels,
                     "Beams that meet an edge return from between its two sides");
    addNumber(command, "--tilt", options.tiltDegrees, 0, 15,
              "The scanner leans so much, unknown to the log (0)")
        ->type_name("DEG");
    addNumber(command, "--map-error", options.mapError, 0, 1,
              "Standard deviation of the map's walls from the real ones (0.01)")
        ->type_name("M");
}

void addRobot(CLI::App& command, SimulateOptions& options) {
    command
        .add_option("--pose-sigma", options.poseSigma,
                    "Standard deviations of the poses from the true ones (0.03,1)")
        ->check(notEmpty)
        ->type_name("M,DEG");
    addNumber(command, "--stated-factor", options.statedFactor, 0.01, 100,
              "The log states F times these: poses that boast, or are too modest (1)")
        ->type_name("F");
    addNumber(command, "--speed", options.speed, 0, 20, "Of the robot while it scans (0)")
        ->type_name("M/S");
    addNumber(command, "--yaw-rate", options.yawRateDegrees, -180, 180,
              "Of the robot while it scans (0)")
        ->type_name("DEG/S");
    command.add_flag("--no-compensation", options.noCompensation,
                     "The log does not know of the movement during a scan");
}

}  // namespace

void SimulateOptions::addTo(CLI::App& command) {
    const auto worlds = evaluation::sceneNames();
    command.add_option("WORLD", world, fmt::format("What is scanned: {}", fmt::join(worlds, ", ")))
        ->required()
        ->type_name("");
    command.add_option("-o,--out", folder, "Folder of the log, its maps and its ground truth")
        ->required()
        ->type_name("FOLDER");
    addSensor(command, *this);
    command.add_option("--scans", scans, "Turns, from places along a drive (10)")
        ->check(between(1, 1e6))
        ->type_name("N");
    command.add_option("--seed", seed, "Of all that is random (1)")
        ->check(notNegative)
        ->type_name("N");
    addNoise(command, *this);
    addRobot(command, *this);
    command.add_flag("--force", force, "Replace existing files");
    command.add_flag("--quiet", quiet, "No progress and no summary");
}

}  // namespace offmap::app
