// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/VelodynePackets.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <chrono>
#include <cmath>

namespace offmap::rawlog {
namespace {

using namespace std::chrono_literals;
using test::emptyVlp16Packet;
using Scan = mrpt::obs::CObservationVelodyneScan;

const char* const realScan = "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog";

Scan scanOf(std::vector<test::VelodynePacket> packets) {
    Scan scan;
    scan.timestamp = mrpt::Clock::fromDouble(1.7e9);
    scan.scan_packets = std::move(packets);
    return scan;
}

double microseconds(mrpt::Clock::duration d) {
    return std::chrono::duration<double, std::micro>(d).count();
}

TEST(VelodynePackets, realScanGivesAllFirings) {
    const auto scans = test::observationsIn<Scan>(realScan);
    ASSERT_EQ(scans.size(), 1U);
    const VelodyneReturns decoded = decodePackets(*scans[0]);
    EXPECT_EQ(decoded.firings.size(), 75U * 12 * 2);
    size_t returns = 0;
    for (size_t slot = 0; slot < 75 * slotsPerPacket; ++slot) {
        if (distanceOf(returnInSlot(*scans[0], slot)) != 0) ++returns;
    }
    EXPECT_EQ(returns, 22591U);
    EXPECT_EQ(decoded.points.size(), returns);
    EXPECT_EQ(decoded.slots.size(), returns);
}

// MRPT decodes the first firing of every block, in the same order.
TEST(VelodynePackets, firstFiringsAgreeWithMrpt) {
    auto scan = *test::observationsIn<Scan>(realScan).at(0);
    const VelodyneReturns decoded = decodePackets(scan);
    scan.minRange = 0;
    scan.maxRange = 1000;
    Scan::TGeneratePointCloudParameters all;
    all.minDistance = 0;
    scan.generatePointCloud(all);
    const auto& cloud = scan.point_cloud;
    ASSERT_EQ(cloud.size(), 11305U);

    size_t m = 0;
    for (size_t i = 0; i < decoded.points.size(); ++i) {
        if (decoded.slots[i] % 32 >= 16) continue;
        const auto& p = decoded.points[i];
        ASSERT_LT(m, cloud.size());
        EXPECT_EQ(cloud.laser_id[m], static_cast<int>(decoded.slots[i] % 16));
        const mrpt::math::TPoint3Df q(cloud.x[m], cloud.y[m], cloud.z[m]);
        const double floats = 4e-7;  // relative, of single precision coordinates
        EXPECT_NEAR(q.z, p.z, floats * std::abs(p.z));
        EXPECT_NEAR(std::hypot(q.x, q.y), std::hypot(p.x, p.y), floats * std::hypot(p.x, p.y));
        // [1/100 deg] MRPT rounds azimuths to whole ones, and its table of sines has 35,999 steps
        // to the circle instead of 36,000, which adds between 0 and 1.
        const double clockwise = std::atan2(p.y, p.x) - std::atan2(q.y, q.x);
        const double off = 100 * mrpt::RAD2DEG(mrpt::math::wrapToPi(clockwise));
        EXPECT_GE(off, -0.5 - 100 * mrpt::RAD2DEG(floats)) << "point " << m;
        EXPECT_LE(off, 1.5 + 100 * mrpt::RAD2DEG(floats)) << "point " << m;
        ++m;
    }
    EXPECT_EQ(m, cloud.size());
}

TEST(VelodynePackets, clockwiseRotationTurnsRight) {
    auto packet = emptyVlp16Packet(0);
    for (size_t b = 0; b < 12; ++b) test::setRotation(packet, b, 9000);  // stands still
    test::setReturn(packet, 0, 14, 2500, 1);                             // laser at -1 degree, 5 m
    const VelodyneReturns decoded = decodePackets(scanOf({packet}));
    ASSERT_EQ(decoded.points.size(), 1U);
    const double tolerance = 5.0 * 2e-7;  // float
    EXPECT_NEAR(decoded.points[0].x, 0, tolerance);
    EXPECT_NEAR(decoded.points[0].y, -5.0 * std::cos(mrpt::DEG2RAD(1.0)), tolerance);
    EXPECT_NEAR(decoded.points[0].z, -5.0 * std::sin(mrpt::DEG2RAD(1.0)), tolerance);
    EXPECT_NEAR(decoded.firings[0].azimuth, mrpt::DEG2RAD(-90.0), 1e-12);
    EXPECT_EQ(decoded.slots[0], 14U);
}

// 40 hundredths of a degree a block: 20 a firing, 40 * 2.304 / 110.592 = 0.8333 a laser.
TEST(VelodynePackets, azimuthFollowsTheTimeOfTheLaser) {
    auto packet = emptyVlp16Packet(0);
    for (size_t b = 0; b < 12; ++b) test::setRotation(packet, b, 35900 + 40 * static_cast<int>(b));
    test::setReturn(packet, 0, 12, 5000, 1);
    test::setReturn(packet, 11, 16 + 12, 5000, 1);
    const VelodyneReturns decoded = decodePackets(scanOf({packet}));
    ASSERT_EQ(decoded.points.size(), 2U);
    const auto clockwise = [](const auto& p) { return -mrpt::RAD2DEG(std::atan2(p.y, p.x)); };
    const double tolerance = mrpt::RAD2DEG(2e-7);  // float
    EXPECT_NEAR(clockwise(decoded.points[0]), 359.0 - 360.0 + 0.1, tolerance);
    EXPECT_NEAR(clockwise(decoded.points[1]), 359.0 - 360.0 + 4.4 + 0.2 + 0.1, tolerance);
}

TEST(VelodynePackets, firingTimesFollowThePacketsOverTheFullHour) {
    const auto scan = scanOf({emptyVlp16Packet(3'599'999'500), emptyVlp16Packet(827)});
    const auto firings = decodePackets(scan).firings;
    ASSERT_EQ(firings.size(), 48U);
    const double tick = 0.1;  // [us] of mrpt::Clock
    EXPECT_EQ(firings[0].time, scan.timestamp);
    EXPECT_NEAR(microseconds(firings[3].time - scan.timestamp), 110.592 + 55.296, tick);
    EXPECT_EQ(firings[24].time - scan.timestamp, 1327us);
}

TEST(VelodynePackets, mangledBlockHasNoReturns) {
    auto packet = emptyVlp16Packet(0);
    test::setReturn(packet, 3, 0, 500, 1);
    test::setReturn(packet, 4, 0, 500, 1);
    test::putBytes<uint16_t>(packet, 3 * test::velodyneBlockBytes, 0x1234);
    const VelodyneReturns decoded = decodePackets(scanOf({packet}));
    EXPECT_EQ(decoded.firings.size(), 22U);
    EXPECT_EQ(decoded.slots, std::vector<uint32_t>{4 * 32});
}

TEST(VelodynePackets, calibrationOfAnotherScannerIsRefused) {
    auto scan = scanOf({emptyVlp16Packet(0)});
    scan.calibration.laser_corrections.resize(32);
    EXPECT_THROW(decodePackets(scan), std::invalid_argument);
}

TEST(VelodynePackets, calibratedDistanceOffsetIsAdded) {
    auto packet = emptyVlp16Packet(0);
    test::setReturn(packet, 0, 0, 1000, 1);
    auto scan = scanOf({packet});
    scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
    scan.calibration.laser_corrections[0].distanceCorrection = 0.25;
    const auto points = decodePackets(scan).points;
    ASSERT_EQ(points.size(), 1U);
    EXPECT_NEAR(std::hypot(points[0].x, points[0].y, points[0].z), 2.25, 2.25 * 2e-7);
}

}  // namespace
}  // namespace offmap::rawlog
