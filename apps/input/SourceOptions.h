// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace offmap::app {

/// Where scans come from while one watches, as a command line says it.
struct SourceOptions {
    std::string source;       ///< a rawlog, a capture, an INI file, or "udp" or "udp:PORT"
    std::string track;        ///< "x,y,yaw_deg"; empty: poses are not tracked
    std::string speed = "1";  ///< a factor, or "max"
    bool follow = false;
    std::string label = "VELODYNE";

    /// All but the source, which each program calls in its own way.
    void addTo(CLI::App& command);

    /// Infinite for "max". \throw UsageError
    double speedFactor() const;
    /// Of "udp:2368"; none for another source. \throw UsageError for a port that is none
    std::optional<uint16_t> udpPort() const;
    bool isCapture() const;
    /// An INI file that rawlog-grabber takes.
    bool isGrabberFile() const;
};

}  // namespace offmap::app
