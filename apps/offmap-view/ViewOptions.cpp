// SPDX-License-Identifier: BSD-3-Clause
#include "ViewOptions.h"

#include "input/UsageError.h"

namespace offmap::window {

void ViewOptions::addTo(CLI::App& app) {
    app.add_option("LOG", log, "A rawlog, or the capture of a Velodyne (.pcap)")
        ->type_name("LOG|F.pcap");
    app.add_option("--live", live, "A Velodyne on the network, or the sensors of an INI file")
        ->type_name("udp[:PORT]|INI");
    app.add_flag("--play", play, "Begin to play at once");
    shared.addTo(app);
    app.get_option("--map")->required(false);
    from.addTo(app);
}

app::LiveRequest ViewOptions::request() const {
    if (!log.empty() && !live.empty()) {
        throw app::UsageError("a log and --live are given; one of them is to be shown");
    }
    app::LiveRequest request;
    request.from = from;
    request.from.source = log.empty() ? live : log;
    request.shared = shared;
    request.forWindow = true;
    // What is wrong with these is told now, not in the window.
    request.from.speedFactor();
    request.from.udpPort();
    shared.mapFile.request({});
    return request;
}

}  // namespace offmap::window
