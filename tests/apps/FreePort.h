// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/RunProgram.h"

#include <arpa/inet.h>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace offmap::test {

/// That nobody listens at for now.
inline uint16_t freeUdpPort() {
    const int handle = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    socklen_t size = sizeof address;
    ::bind(handle, reinterpret_cast<const sockaddr*>(&address), size);
    ::getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size);
    ::close(handle);
    return ntohs(address.sin_port);
}

/// Whether a socket of this machine is bound to the port, as the kernel lists them:
/// "   1: 00000000:0940 ...", in hexadecimal digits.
inline bool isListenedAt(uint16_t port) {
    char wanted[8];
    std::snprintf(wanted, sizeof wanted, ":%04X ", port);
    std::ifstream sockets("/proc/net/udp");
    for (std::string line; std::getline(sockets, line);) {
        const size_t address = line.find(": ");
        if (address != std::string::npos && line.find(wanted, address) == address + 10) return true;
    }
    return false;
}

/// False if the program ended before.
inline bool waitUntilListened(uint16_t port, const RunningProgram& program) {
    while (!isListenedAt(port)) {
        if (!program.runs()) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

}  // namespace offmap::test
