// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VelodyneStream.h"

#include <string>

namespace offmap::test {

template <class Value>
void put(std::string& bytes, Value value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A capture as libpcap writes it: little-endian, microseconds, Ethernet.
inline std::string captureHead() {
    std::string bytes;
    put<uint32_t>(bytes, 0xa1b2c3d4);
    put<uint16_t>(bytes, 2);
    put<uint16_t>(bytes, 4);
    put<uint64_t>(bytes, 0);
    put<uint32_t>(bytes, 65535);
    put<uint32_t>(bytes, 1);
    return bytes;
}

/// A frame of Ethernet, IPv4 and UDP headers and its content. Of the headers stands what filters
/// look at: the protocols and the port that it goes to.
inline void addFrame(std::string& bytes, double time, const void* content, uint32_t size,
                     uint16_t port = 2368) {
    std::string headers(14 + 20 + 8, '\0');
    headers[12] = 0x08;    // IPv4
    headers[14] = 0x45;    // of five words
    headers[14 + 9] = 17;  // UDP
    headers[14 + 20 + 2] = static_cast<char>(port >> 8);
    headers[14 + 20 + 3] = static_cast<char>(port & 0xff);
    const auto seconds = static_cast<uint32_t>(time);
    const auto length = static_cast<uint32_t>(headers.size()) + size;
    put<uint32_t>(bytes, seconds);
    put<uint32_t>(bytes, static_cast<uint32_t>((time - seconds) * 1e6));
    put<uint32_t>(bytes, length);
    put<uint32_t>(bytes, length);
    bytes.append(headers);
    bytes.append(static_cast<const char*>(content), size);
}

inline std::string velodyneCapture(uint64_t packets) {
    const VelodyneStream stream;
    std::string bytes = captureHead();
    for (uint64_t n = 0; n < packets; ++n) {
        const auto packet = stream.packet(n);
        addFrame(bytes, 1.7e9 + 1e-6 * VelodyneStream::period * double(n), &packet, sizeof packet);
        if (n % 50 == 0) addFrame(bytes, 1.7e9, "something else", 14, 8309);
    }
    return bytes;
}

}  // namespace offmap::test
