// SPDX-License-Identifier: BSD-3-Clause
#include "LiveCommandOptions.h"

namespace offmap::app {

void LiveCommandOptions::addTo(CLI::App& command) {
    command
        .add_option(
            "SOURCE", from.source,
            "A rawlog, the capture of a Velodyne (.pcap), sensors as rawlog-grabber takes them "
            "(.ini), or udp for a Velodyne on the network")
        ->required()
        ->type_name("LOG|F.pcap|F.ini|udp[:PORT]");
    shared.addTo(command);
    from.addTo(command);
    command.add_option("--waiting", waiting, "Turns that may wait; then the oldest is dropped (2)")
        ->check(CLI::Range(1, 1000).description(""))
        ->type_name("N");
    command.add_option("--seconds", seconds, "End after so many seconds")
        ->check(CLI::PositiveNumber.description(""))
        ->type_name("S");
    command.add_option("--record", record, "Rawlog of the reduced scans; it appears at the end")
        ->type_name("FILE");
    command.add_flag("--force", force, "Replace an existing recording");
    command.add_flag("--quiet", quiet, "No figures while it runs");
}

}  // namespace offmap::app
