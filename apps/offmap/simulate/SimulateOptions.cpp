// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateOptions.h"

#include "../NumberList.h"

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

}  // namespace

void SimulateOptions::addTo(CLI::App& command) {
    const auto worlds = evaluation::sceneNames();
    command.add_option("WORLD", world, fmt::format("What is scanned: {}", fmt::join(worlds, ", ")))
        ->required()
        ->type_name("");
    command.add_option("-o,--out", folder, "Folder of the log, its maps and its ground truth")
        ->required()
        ->type_name("FOLDER");
    command
        .add_option("--class", scanClass,
                    "Class of the observations (pointcloud); velodyne: packets of a VLP-16, sweep: "
                    "a 2D scanner that turns, rangeimage: a depth camera")
        ->check(CLI::IsMember({"pointcloud", "velodyne", "rotating", "sweep", "rangeimage"})
                    .description(""))
        ->type_name("pointcloud|velodyne|rotating|sweep|rangeimage");
    command
        .add_option("--scanner", scanner,
                    "181 x 181 beams of the paper, a VLP-16, or 2048 x 128 (paper)")
        ->check(CLI::IsMember({"paper", "vlp16", "dense"}).description(""))
        ->type_name("paper|vlp16|dense");
    command.add_option("--scans", scans, "Turns, from places along a drive (10)")
        ->check(between(1, 1e6))
        ->type_name("N");
    command.add_option("--seed", seed, "Of all that is random (1)")
        ->check(notNegative)
        ->type_name("N");
    const auto number = [&command](const char* name, double& value, double low, double high,
                                   const char* unit, const char* text) {
        command.add_option(name, value, text)->check(between(low, high))->type_name(unit);
    };
    number("--range-noise", rangeNoise, 0, 1, "M", "Standard deviation of a range (0.02)");
    number("--angle-noise", angleNoiseDegrees, 0, 5, "DEG",
           "Standard deviation of a beam's direction (0)");
    command.add_flag("--mixed-pixels", mixedPixels,
                     "Beams that meet an edge return from between its two sides");
    number("--tilt", tiltDegrees, 0, 15, "DEG",
           "The scanner leans so much, unknown to the log (0)");
    number("--map-error", mapError, 0, 1, "M",
           "Standard deviation of the map's walls from the real ones (0.01)");
    command
        .add_option("--pose-sigma", poseSigma,
                    "Standard deviations of the poses from the true ones (0.03,1)")
        ->check(notEmpty)
        ->type_name("M,DEG");
    number("--stated-factor", statedFactor, 0.01, 100, "F",
           "The log states F times these: poses that boast, or are too modest (1)");
    number("--speed", speed, 0, 20, "M/S", "Of the robot while it scans (0)");
    number("--yaw-rate", yawRateDegrees, -180, 180, "DEG/S", "Of the robot while it scans (0)");
    command.add_flag("--no-compensation", noCompensation,
                     "The log does not know of the movement during a scan");
    command.add_flag("--force", force, "Replace existing files");
    command.add_flag("--quiet", quiet, "No progress and no summary");
}

}  // namespace offmap::app
