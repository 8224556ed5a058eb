// SPDX-License-Identifier: BSD-3-Clause
#include "../support/VelodyneFuzz.h"

#include <gtest/gtest.h>

#include <random>

namespace offmap::rawlog {
namespace {

std::string failureOf(const std::vector<uint8_t>& input) {
    try {
        test::fuzzVelodyne(input);
        return {};
    } catch (const std::exception& error) {
        return error.what();
    }
}

TEST(VelodyneFuzz, seedsAreDecoded) {
    for (const auto& seed : test::velodyneFuzzSeeds()) EXPECT_EQ(failureOf(seed), "") << +seed[0];
}

TEST(VelodyneFuzz, noMutationBreaksTheDecoder) {
    std::mt19937 random(5);
    const auto below = [&](size_t n) {
        return std::uniform_int_distribution<size_t>(0, n - 1)(random);
    };
    for (const auto& seed : test::velodyneFuzzSeeds()) {
        for (int round = 0; round < 30; ++round) {
            auto input = seed;
            for (size_t changes = 1 + below(40); changes > 0; --changes) {
                // Mostly in the headers and rotations of blocks, which take 4 of 100 bytes.
                const size_t block = below(36);
                const size_t place = below(3) == 0 ? below(input.size())
                                                   : input.size() - 1206 * (1 + block / 12) +
                                                         block % 12 * 100 + below(4);
                input[place] = static_cast<uint8_t>(below(256));
            }
            if (below(4) == 0) input.resize(below(input.size()));
            EXPECT_EQ(failureOf(input), "") << +seed[0] << ", round " << round;
        }
    }
}

// That the checks notice anything: a scan that is not the one that was organised.
TEST(VelodyneFuzz, unsoundColumnsAreNoticed) {
    mrpt::obs::CObservationVelodyneScan scan;
    scan.scan_packets = {test::emptyVlp16Packet(0)};
    test::setReturn(scan.scan_packets[0], 0, 0, 1000, 1);
    const test::DrivenVehicle still{mrpt::poses::CPose3D()};
    const auto shared = std::make_shared<mrpt::obs::CObservationVelodyneScan>(scan);
    TurnScan turn = VelodyneScan().organize({shared}, still, {});
    EXPECT_NO_THROW(test::requireSoundColumns(turn, scan));
    turn.scan.sourceIndex[0] = 1;
    EXPECT_THROW(test::requireSoundColumns(turn, scan), std::logic_error);
    turn.scan.sourceIndex[0] = 384;
    EXPECT_THROW(test::requireSoundColumns(turn, scan), std::logic_error);
}

}  // namespace
}  // namespace offmap::rawlog
