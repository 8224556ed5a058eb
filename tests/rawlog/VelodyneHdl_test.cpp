// SPDX-License-Identifier: BSD-3-Clause
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/VelodynePackets.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <chrono>
#include <cmath>
#include <set>

namespace offmap::rawlog {
namespace {

using mrpt::DEG2RAD;
using mrpt::RAD2DEG;
using Scan = mrpt::obs::CObservationVelodyneScan;

/// Relative, of single precision coordinates.
constexpr double floats = 4e-7;

Scan scanOf(std::vector<test::VelodynePacket> packets) {
    Scan scan;
    scan.timestamp = mrpt::Clock::fromDouble(1.7e9);
    scan.scan_packets = std::move(packets);
    return scan;
}

Scan hdl64Of(std::vector<test::VelodynePacket> packets) {
    Scan scan = scanOf(std::move(packets));
    scan.calibration = test::hdl64Calibration();
    return scan;
}

double clockwise(const mrpt::math::TPoint3Df& p) { return -RAD2DEG(std::atan2(p.y, p.x)); }

double range(const mrpt::math::TPoint3Df& p) { return std::hypot(p.x, p.y, p.z); }

double microseconds(mrpt::Clock::duration d) {
    return std::chrono::duration<double, std::micro>(d).count();
}

TEST(Hdl32, everyLaserOfABlockIsOfOneFiring) {
    auto packet = test::emptyHdl32Packet(0);
    for (size_t b = 0; b < 12; ++b) test::setRotation(packet, b, 9000);      // stands still
    for (size_t l = 0; l < 32; ++l) test::setReturn(packet, 2, l, 2500, 1);  // 5 m
    const VelodyneReturns decoded = decodePackets(scanOf({packet}));
    EXPECT_EQ(decoded.firings.size(), 12U);
    ASSERT_EQ(decoded.points.size(), 32U);
    // Elevations from the manual, lasers in the order of firing.
    for (const auto& [laser, elevation] :
         {std::pair(0, -30.67), {1, -9.33}, {15, 0.0}, {16, -20.0}, {30, -10.67}, {31, 10.67}}) {
        const auto& p = decoded.points[static_cast<size_t>(laser)];
        EXPECT_EQ(decoded.lasers[static_cast<size_t>(laser)], laser);
        EXPECT_NEAR(p.x, 0, 5 * floats);
        EXPECT_NEAR(p.y, -5 * std::cos(DEG2RAD(elevation)), 5 * floats);
        EXPECT_NEAR(p.z, 5 * std::sin(DEG2RAD(elevation)), 5 * floats);
    }
    EXPECT_EQ(decoded.slots[31], 2U * 32 + 31);
}

// 17 hundredths of a degree a block of 46.08 us: 17 * 1.152 / 46.08 = 0.425 a laser.
TEST(Hdl32, timeAndAzimuthFollowTheFirings) {
    auto packet = test::emptyHdl32Packet(0);
    for (size_t b = 0; b < 12; ++b) test::setRotation(packet, b, 17 * static_cast<int>(b));
    test::setReturn(packet, 1, 20, 5000, 1);
    test::setReturn(packet, 11, 31, 5000, 1);
    const auto scan = scanOf({packet, test::emptyHdl32Packet(553)});
    const VelodyneReturns decoded = decodePackets(scan);
    ASSERT_EQ(decoded.points.size(), 2U);
    EXPECT_NEAR(clockwise(decoded.points[0]), 0.17 + 0.00425 * 20, RAD2DEG(floats));
    EXPECT_NEAR(clockwise(decoded.points[1]), 0.17 * 11 + 0.00425 * 31, RAD2DEG(floats));
    EXPECT_NEAR(decoded.firings[1].azimuth, -DEG2RAD(0.17 + 0.00425 * 15.5), 1e-12);
    const double tick = 0.1;  // [us] of mrpt::Clock
    EXPECT_NEAR(microseconds(decoded.firings[11].time - scan.timestamp), 11 * 46.08, tick);
    EXPECT_NEAR(microseconds(decoded.firings[12].time - scan.timestamp), 553, tick);
}

TEST(Hdl64, upperAndLowerBankAreOneFiring) {
    auto packet = test::emptyHdl64Packet(0);
    for (size_t b = 0; b < 12; ++b) test::setRotation(packet, b, 9000 + 17 * int(b / 2));
    for (const size_t b : {4, 5}) test::setReturn(packet, b, 1, 2500, 1);
    const auto scan = hdl64Of({packet});
    const VelodyneReturns decoded = decodePackets(scan);
    ASSERT_EQ(decoded.firings.size(), 6U);
    const VelodyneFiring& firing = decoded.firings[2];
    EXPECT_NEAR(firing.azimuth, -DEG2RAD(90.34), 1e-12);
    EXPECT_NEAR(microseconds(firing.time - scan.timestamp), 2 * 48, 0.1);
    ASSERT_EQ(firing.end - firing.begin, 2U);
    EXPECT_EQ(decoded.lasers, (std::vector<uint8_t>{1, 33}));
    EXPECT_EQ(decoded.slots, (std::vector<uint32_t>{4 * 32 + 1, 5 * 32 + 1}));
    // Lasers 1 and 33: corrections of -1.5 degrees, 0.05 and 0 m, elevations 1.67 and -9.33.
    EXPECT_NEAR(clockwise(decoded.points[0]), 90.34 + 1.5, RAD2DEG(floats));
    EXPECT_NEAR(clockwise(decoded.points[1]), 90.34 + 1.5, RAD2DEG(floats));
    EXPECT_NEAR(range(decoded.points[0]), 5.05, 5 * floats);
    EXPECT_NEAR(range(decoded.points[1]), 5, 5 * floats);
    EXPECT_NEAR(decoded.points[0].z, 5.05 * std::sin(DEG2RAD(2 - 1.0 / 3)), 5 * floats);
    EXPECT_NEAR(decoded.points[1].z, 5 * std::sin(DEG2RAD(-9.33)), 5 * floats);
}

TEST(Hdl64, bankWithoutItsPartnerIsAFiringByItself) {
    auto packet = test::emptyHdl64Packet(0);
    for (size_t b = 0; b < 12; ++b) {
        test::setRotation(packet, b, 17 * int(b / 2));
        test::setReturn(packet, b, 0, 1000, 1);
    }
    test::setHeader(packet, 2, 0x1234);
    test::setRotation(packet, 7, 9000);
    const VelodyneReturns decoded = decodePackets(hdl64Of({packet}));
    EXPECT_EQ(decoded.firings.size(), 7U);
    EXPECT_EQ(decoded.lasers, (std::vector<uint8_t>{0, 32, 32, 0, 32, 0, 32, 0, 32, 0, 32}));
}

TEST(Hdl64, statusBytesMeanNoReturnMode) {
    auto packet = test::emptyHdl64Packet(0);
    packet.laser_return_mode = 0x39;
    for (size_t b = 0; b < 2; ++b) test::setReturn(packet, b, 7, 1000, 1);
    const VelodyneReturns decoded = decodePackets(hdl64Of({packet}));
    EXPECT_EQ(decoded.lasers, (std::vector<uint8_t>{7, 39}));
}

}  // namespace
}  // namespace offmap::rawlog
