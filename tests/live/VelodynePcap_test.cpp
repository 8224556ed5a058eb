// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"
#include "VelodyneStream.h"

#include <offmap/live/VelodynePcap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace offmap::live {
namespace {

constexpr double noWait = std::numeric_limits<double>::infinity();

template <class Value>
void put(std::string& bytes, Value value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A capture as libpcap writes it: little-endian, microseconds, Ethernet.
std::string captureHead() {
    std::string bytes;
    put<uint32_t>(bytes, 0xa1b2c3d4);
    put<uint16_t>(bytes, 2);
    put<uint16_t>(bytes, 4);
    put<uint64_t>(bytes, 0);
    put<uint32_t>(bytes, 65535);
    put<uint32_t>(bytes, 1);
    return bytes;
}

/// A frame of Ethernet, IP and UDP headers, which nobody reads, and its content.
void addFrame(std::string& bytes, double time, const void* content, uint32_t size) {
    constexpr uint32_t headers = 14 + 20 + 8;
    const auto seconds = static_cast<uint32_t>(time);
    put<uint32_t>(bytes, seconds);
    put<uint32_t>(bytes, static_cast<uint32_t>((time - seconds) * 1e6));
    put<uint32_t>(bytes, headers + size);
    put<uint32_t>(bytes, headers + size);
    bytes.append(headers, '\0');
    bytes.append(static_cast<const char*>(content), size);
}

std::string capture(uint64_t packets) {
    const test::VelodyneStream stream;
    std::string bytes = captureHead();
    for (uint64_t n = 0; n < packets; ++n) {
        const VelodynePacket packet = stream.packet(n);
        addFrame(bytes, 1.7e9 + 1e-6 * test::VelodyneStream::period * double(n), &packet,
                 sizeof packet);
        if (n % 50 == 0) addFrame(bytes, 1.7e9, "a position packet", 17);
    }
    return bytes;
}

class Pcap : public testing::Test {
 protected:
    std::filesystem::path written(const std::string& bytes) const {
        std::ofstream(file_, std::ios::binary) << bytes;
        return file_;
    }
    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "drive.pcap";
};

TEST_F(Pcap, deliversAllPacketsInTurns) {
    VelodynePcap source(written(capture(400)), "VLP16", noWait);
    EXPECT_TRUE(source.waits());
    size_t packets = 0;
    while (const auto turn = source.next({})) {
        using Scan = mrpt::obs::CObservationVelodyneScan;
        const auto scan = std::dynamic_pointer_cast<const Scan>(turn->turn.front());
        packets += scan->scan_packets.size();
        EXPECT_GE(mrpt::Clock::toDouble(scan->timestamp), 1.7e9 - 1e-3);
        EXPECT_LE(mrpt::Clock::toDouble(scan->timestamp), 1.7e9 + 1) << "the time of the capture";
    }
    EXPECT_EQ(packets, 400U) << "the last turn as well";
    EXPECT_EQ(source.health().state, SourceState::Ended);
    EXPECT_EQ(source.health().packetsMissing, 0U);
}

TEST_F(Pcap, aDamagedCaptureDeliversWhatStandsBefore) {
    const std::string whole = capture(200);
    VelodynePcap source(written(whole.substr(0, whole.size() - 100)), "VLP16", noWait);
    EXPECT_TRUE(source.next({}));
    while (source.next({})) {
    }
    EXPECT_EQ(source.health().state, SourceState::Failed);
    EXPECT_THAT(source.health().message, testing::HasSubstr("drive.pcap"));
}

TEST_F(Pcap, aCaptureOfSomethingElseFailsWithItsReason) {
    std::string bytes = captureHead();
    addFrame(bytes, 1.7e9, "hello", 5);
    VelodynePcap source(written(bytes), "VLP16", noWait);
    EXPECT_FALSE(source.next({}));
    EXPECT_EQ(source.health().state, SourceState::Failed);
    EXPECT_THAT(source.health().message, testing::HasSubstr("no packets of a Velodyne"));
}

TEST_F(Pcap, whatIsNoCaptureIsRefused) {
    EXPECT_THROW(VelodynePcap(written("hello"), "VLP16", 1), std::runtime_error);
    EXPECT_THROW(VelodynePcap(folder_ / "none.pcap", "VLP16", 1), std::runtime_error);
}

}  // namespace
}  // namespace offmap::live
