// SPDX-License-Identifier: BSD-3-Clause
#include "SourceOptions.h"

#include "NumberList.h"
#include "UsageError.h"

#include <offmap/live/VelodyneUdp.h>

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <limits>

namespace offmap::app {

void SourceOptions::addTo(CLI::App& command) {
    command
        .add_option("--track", track,
                    "Where the robot is at the beginning; from there its scans tell. Needs "
                    "--method aligned")
        ->type_name("X,Y,YAW_DEG")
        ->check(notEmpty);
    command
        .add_option("--speed", speed,
                    "How many times as fast as recorded a log or capture is replayed (1)")
        ->type_name("FACTOR|max");
    command.add_flag("--follow", follow, "The log is still being written: wait for what comes");
    command.add_option("--label", label, "Sensor label of scans from the network or a capture")
        ->type_name("LABEL");
}

double SourceOptions::speedFactor() const {
    if (speed == "max") return std::numeric_limits<double>::infinity();
    const double factor = parseNumbers(speed, "--speed", "factor")[0];
    constexpr double slowest = 0.01, fastest = 1000;
    if (factor < slowest || factor > fastest) {
        throw UsageError(
            fmt::format("--speed {}: allowed is {} ... {}, or max", speed, slowest, fastest));
    }
    return factor;
}

std::optional<uint16_t> SourceOptions::udpPort() const {
    if (source == "udp") return live::VelodyneUdp::defaultPort;
    constexpr std::string_view prefix = "udp:";
    if (!source.starts_with(prefix)) return std::nullopt;
    uint16_t port = 0;
    const char* end = source.data() + source.size();
    const auto parsed = std::from_chars(source.data() + prefix.size(), end, port);
    if (parsed.ec != std::errc{} || parsed.ptr != end || port == 0) {
        throw UsageError(fmt::format("{}: a port is 1 ... 65535", source));
    }
    return port;
}

bool SourceOptions::isCapture() const {
    const std::string extension = std::filesystem::path(source).extension().string();
    return extension == ".pcap" || extension == ".pcapng";
}

bool SourceOptions::isGrabberFile() const {
    return std::filesystem::path(source).extension() == ".ini";
}

}  // namespace offmap::app
