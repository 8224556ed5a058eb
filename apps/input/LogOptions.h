// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ConfigOptions.h"
#include "PoseOptions.h"

#include <offmap/rawlog/Config.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace offmap::app {

/// What every subcommand that places the scans of logs asks for: parameters, poses and mountings.
struct LogOptions {
    ConfigOptions config;
    PoseOptions poses;
    std::vector<std::string> sensorPoses;  ///< "LABEL=x,y,z,yaw_deg,pitch_deg,roll_deg"

    void addTo(CLI::App& command);

    /// \param settings "key=value", which go over those of the command line
    /// \throw UsageError for a wrong configuration, file or command line
    rawlog::Config readConfig(const std::vector<std::string>& settings = {}) const;
};

}  // namespace offmap::app
