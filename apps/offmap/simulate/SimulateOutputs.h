// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LogSimulation.h"

#include <offmap/evaluation/TruthFile.h>
#include <offmap/rawlog/GuardedRun.h>
#include <offmap/rawlog/OutputFile.h>
#include <offmap/rawlog/RawlogWriter.h>

#include <filesystem>
#include <optional>

namespace offmap::app {

/// What simulate writes.
struct SimulatedFiles {
    std::filesystem::path scans, map, grid, truth;
    std::filesystem::path config;  ///< empty: none is needed
};

/// \param needsElevations whether a configuration has to tell the elevations of the rows
SimulatedFiles filesIn(const std::filesystem::path& folder, bool needsElevations);

/// All files of a simulation, complete before the first one appears.
class SimulateOutputs {
 public:
    SimulateOutputs(const SimulatedFiles& files, bool force, rawlog::GuardedStatus& status);

    void writeMaps(const std::vector<core::Wall>& walls);
    void writeConfig(const rawlog::SensorConfig& config);
    void add(const mrpt::obs::CObservation& entry) { scans_.write(entry); }
    void add(const LoggedTurn& turn);
    void publish();

 private:
    rawlog::GuardedStatus& status_;
    rawlog::RawlogWriter scans_;
    rawlog::OutputFile grid_, map_, truth_;
    std::optional<rawlog::OutputFile> config_;
    evaluation::TruthWriter truthWriter_;
};

}  // namespace offmap::app
