// SPDX-License-Identifier: BSD-3-Clause
#include "../live/VelodyneStream.h"

#include <CLI/CLI.hpp>

#include <arpa/inet.h>
#include <chrono>
#include <cstdio>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

// Sends what a VLP-16 sends to a port of this machine, turn after turn, and tells how much that
// was.
int main(int argc, char** argv) {
    using Steady = std::chrono::steady_clock;
    CLI::App app("Sends the packets of a VLP-16 that turns and turns");
    uint16_t port = 2368;
    double factor = 1, seconds = 10;
    app.add_option("--port", port, "of 127.0.0.1 (2368)");
    app.add_option("--factor", factor, "How many times as fast as the sensor (1)")
        ->check(CLI::Range(0.01, 1000.0));
    app.add_option("--seconds", seconds, "How long (10)")->check(CLI::Range(0.0, 86400.0));
    CLI11_PARSE(app, argc, argv);

    const int handle = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const offmap::test::VelodyneStream stream;
    const std::chrono::duration<double, std::micro> period(stream.period / factor);
    const auto packets = static_cast<uint64_t>(seconds * 1e6 / period.count());
    const auto begin = Steady::now();
    uint64_t returns = 0;
    for (uint64_t n = 0; n < packets; ++n) {
        const auto due = begin + std::chrono::duration_cast<Steady::duration>(n * period);
        std::this_thread::sleep_until(due);
        const auto packet = stream.packet(n);
        // Not connected: whether somebody listens is nothing that a sensor would notice.
        if (::sendto(handle, &packet, sizeof packet, 0, reinterpret_cast<const sockaddr*>(&address),
                     sizeof address) < 0) {
            std::perror("sendto");
            return 2;
        }
        returns += stream.returns(n);
    }
    ::close(handle);
    std::printf("packets %ju\nturns %ju\nreturns %ju\n", uintmax_t(packets),
                uintmax_t(stream.turnsOf(packets)), uintmax_t(returns));
    return 0;
}
