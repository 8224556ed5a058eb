// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/PoseChoice.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

namespace offmap::app {

/// Where poses come from, as a command line says it.
struct PoseOptions {
    std::string fixed;                 ///< --pose "x,y,yaw_deg"
    std::filesystem::path trajectory;  ///< --trajectory
    std::string label;                 ///< --pose-label
    std::string initial;               ///< --initial-pose "x,y,yaw_deg"
    std::string delay;                 ///< --pose-delay "s"
    std::string sigma;                 ///< --pose-sigma "m,deg"; empty: as configured

    void addTo(CLI::App& command);

    /// \throw UsageError for sigmas that are none, or of nothing
    void setSigmas(rawlog::Config& config) const;
    /// \throw UsageError for a pose or a delay that is none
    rawlog::PoseRequest request() const;
};

}  // namespace offmap::app
