// SPDX-License-Identifier: BSD-3-Clause
#include "SimulateOutputs.h"

#include <offmap/maps/GridWriter.h>
#include <offmap/maps/TextMapWriter.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mrpt/core/bits_math.h>

namespace offmap::app {

SimulatedFiles filesIn(const std::filesystem::path& folder, bool needsElevations) {
    return {folder / "scans.rawlog", folder / "map.lines", folder / "map.gridmap.gz",
            folder / "truth.csv.gz", needsElevations ? folder / "sensor.yaml" : ""};
}

SimulateOutputs::SimulateOutputs(const SimulatedFiles& files, bool force,
                                 rawlog::GuardedStatus& status)
    : status_(status),
      scans_(files.scans, {1, force, &status}),
      grid_(files.grid, {1, force, &status}),
      map_(files.map, {std::nullopt, force, &status}),
      truth_(files.truth, {1, force, &status}),
      truthWriter_([this](std::string_view text) { truth_.write(text); }) {
    if (!files.config.empty()) {
        config_.emplace(files.config, rawlog::OutputOptions{std::nullopt, force, &status});
    }
}

void SimulateOutputs::writeMaps(const std::vector<core::Wall>& walls) {
    constexpr double resolution = 0.05;  // [m]
    map_.write(maps::textMapOf(walls));
    grid_.write(maps::gridMapBytes(maps::gridOf(walls, resolution)));
}

void SimulateOutputs::writeConfig(const rawlog::SensorConfig& config) {
    if (!config_) return;
    std::vector<std::string> degrees;
    for (const double elevation : config.elevations) {
        degrees.push_back(fmt::format("{:.6g}", mrpt::RAD2DEG(elevation)));
    }
    config_->write(fmt::format("sensor:\n  elevations_deg: [{}]\n", fmt::join(degrees, ", ")));
}

void SimulateOutputs::add(const LoggedTurn& turn) {
    for (const auto& entry : turn.entries) scans_.write(*entry);
    for (const auto& observation : turn.truth) truthWriter_.add(observation);
}

void SimulateOutputs::publish() {
    scans_.finish();
    grid_.finish();
    map_.finish();
    truth_.finish();
    if (config_) config_->finish();
    status_.beginPublishing();
    map_.publish();
    grid_.publish();
    if (config_) config_->publish();
    truth_.publish();
    scans_.publish();  // last: where it is, the others are
}

}  // namespace offmap::app
