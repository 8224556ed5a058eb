// SPDX-License-Identifier: BSD-3-Clause
#include "LiveCommandOptions.h"

#include "../NumberList.h"
#include "../UsageError.h"

#include <offmap/live/VelodyneUdp.h>

#include <fmt/format.h>

#include <charconv>
#include <limits>

namespace offmap::app {

void LiveCommandOptions::addTo(CLI::App& command) {
    command
        .add_option("SOURCE", source,
                    "A rawlog, the capture of a Velodyne (.pcap), or udp for one on the network")
        ->required()
        ->type_name("LOG|F.pcap|udp[:PORT]");
    shared.addTo(command);
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
    command.add_option("--waiting", waiting, "Turns that may wait; then the oldest is dropped (2)")
        ->check(CLI::Range(1, 1000).description(""))
        ->type_name("N");
    command.add_option("--seconds", seconds, "End after so many seconds")
        ->check(CLI::PositiveNumber.description(""))
        ->type_name("S");
    command.add_option("--record", record, "Rawlog of the reduced scans; it appears at the end")
        ->type_name("FILE");
    command.add_option("--label", label, "Sensor label of scans from the network or a capture")
        ->type_name("LABEL");
    command.add_flag("--force", force, "Replace an existing recording");
    command.add_flag("--quiet", quiet, "No figures while it runs");
}

double LiveCommandOptions::speedFactor() const {
    if (speed == "max") return std::numeric_limits<double>::infinity();
    const double factor = parseNumbers(speed, "--speed", "factor")[0];
    constexpr double slowest = 0.01, fastest = 1000;
    if (factor < slowest || factor > fastest) {
        throw UsageError(
            fmt::format("--speed {}: allowed is {} ... {}, or max", speed, slowest, fastest));
    }
    return factor;
}

std::optional<uint16_t> LiveCommandOptions::udpPort() const {
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

bool LiveCommandOptions::isCapture() const {
    const std::string extension = std::filesystem::path(source).extension().string();
    return extension == ".pcap" || extension == ".pcapng";
}

}  // namespace offmap::app
