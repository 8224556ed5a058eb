// SPDX-License-Identifier: BSD-3-Clause
#include "TurnsFromPieces.h"
#include "VelodyneStream.h"

#include <offmap/live/VelodyneUdp.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;

/// Sends to a port of this machine.
class Sender {
 public:
    explicit Sender(uint16_t port) : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(port);
        ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    }
    ~Sender() { ::close(socket_); }
    Sender(const Sender&) = delete;
    Sender& operator=(const Sender&) = delete;

    void send(const void* bytes, size_t size) const { ::send(socket_, bytes, size, 0); }
    void sendPackets(uint64_t from, uint64_t to) const {
        for (uint64_t n = from; n < to; ++n) {
            const VelodynePacket packet = stream_.packet(n);
            send(&packet, sizeof packet);
            std::this_thread::sleep_for(50us);
        }
    }

 private:
    int socket_;
    test::VelodyneStream stream_;
};

TEST(VelodyneUdp, deliversWholeTurnsAndWhatIsLeftWhenItStalls) {
    VelodyneUdp source(0, "VLP16", 200ms);
    EXPECT_EQ(source.health().state, SourceState::Starting);
    std::jthread sender([&] { Sender(source.port()).sendPackets(0, 170); });
    size_t packets = 0;
    while (source.health().state != SourceState::Stalled) {
        const auto turn = source.next({});
        ASSERT_TRUE(turn);
        using Scan = mrpt::obs::CObservationVelodyneScan;
        const auto scan = std::dynamic_pointer_cast<const Scan>(turn->turn.front());
        ASSERT_TRUE(scan);
        packets += scan->scan_packets.size();
    }
    EXPECT_EQ(packets, 170U);
    const SourceHealth health = source.health();
    EXPECT_EQ(health.packetsMissing, 0U);
    EXPECT_EQ(health.connectionsLost, 1U);
    sender.join();
    std::jthread again([&] { Sender(source.port()).sendPackets(1000, 1160); });
    EXPECT_TRUE(source.next({}));
    EXPECT_EQ(source.health().state, SourceState::Running);
    EXPECT_EQ(source.health().packetsMissing, 0U) << "it was switched off";
}

TEST(VelodyneUdp, handsOverItsTurnsInPieces) {
    VelodyneUdp source(0, "VLP16", 200ms);
    test::TurnsFromPieces pieces;
    source.onPiece([&](const TurnPiece& piece) { pieces.add(piece); });
    std::jthread sender([&] { Sender(source.port()).sendPackets(0, 200); });
    while (source.health().state != SourceState::Stalled) {
        const auto turn = source.next({});
        ASSERT_TRUE(turn);
        pieces.expectBeginOf(*turn);
    }
    EXPECT_GE(pieces.turns(), 3U);
}

TEST(VelodyneUdp, whatIsNoPacketIsPassedOver) {
    VelodyneUdp source(0, "VLP16", 100ms);
    std::jthread sender([&] {
        const Sender to(source.port());
        const std::string text(1300, 'x');
        to.send(text.data(), 100);
        to.send(text.data(), text.size());
        auto packet = test::emptyVlp16Packet(0);
        packet.velodyne_model_ID = 0x28;
        to.send(&packet, sizeof packet);
        std::this_thread::sleep_for(100ms);
        to.sendPackets(0, 80);
    });
    ASSERT_TRUE(source.next({}));
    EXPECT_EQ(source.health().message, "");
}

TEST(VelodyneUdp, aPortInUseIsAnErrorThatNamesIt) {
    const VelodyneUdp source(0, "VLP16");
    try {
        const VelodyneUdp second(source.port(), "VLP16");
        FAIL() << "two cannot listen at one port";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(std::to_string(source.port())));
    }
}

TEST(VelodyneUdp, stopsWhileNothingComes) {
    VelodyneUdp source(0, "VLP16");
    std::jthread reader([&](const std::stop_token& stop) { EXPECT_FALSE(source.next(stop)); });
    reader.request_stop();
}

}  // namespace
}  // namespace offmap::live
