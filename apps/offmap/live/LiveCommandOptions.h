// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../SharedOptions.h"

#include <filesystem>
#include <optional>
#include <string>

namespace offmap::app {

/// The command line of `offmap live`.
struct LiveCommandOptions {
    std::string source;  ///< a rawlog, a capture, or "udp" with or without ":PORT"
    SharedOptions shared;
    std::string track;        ///< "x,y,yaw_deg"; empty: poses are not tracked
    std::string speed = "1";  ///< a factor, or "max"
    bool follow = false;
    size_t waiting = 2;             ///< turns
    std::optional<double> seconds;  ///< [s] after which it ends
    std::filesystem::path record;   ///< may be empty
    std::string label = "VELODYNE";
    bool force = false, quiet = false;

    void addTo(CLI::App& command);

    /// Infinite for "max". \throw UsageError
    double speedFactor() const;
    /// Of "udp:2368"; none for another source. \throw UsageError for a port that is none
    std::optional<uint16_t> udpPort() const;
    bool isCapture() const;
};

}  // namespace offmap::app
