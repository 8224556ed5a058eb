// SPDX-License-Identifier: BSD-3-Clause
#include "../support/RotatingMaker.h"
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/RotatingGeometry.h>

#include <gtest/gtest.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <chrono>
#include <numbers>

namespace offmap::rawlog {
namespace {

using mrpt::DEG2RAD;
using mrpt::obs::CObservationRotatingScan;
using std::numbers::pi;

// Angles of a few radians, worked out in double with a handful of operations.
constexpr double rounding = 1e-14;

SensorConfig rows(size_t count) { return test::withElevations(std::vector<double>(count)); }

TEST(RotatingGeometry, azimuthsRunFromStartToEndOfSpan) {
    const auto scan = test::emptyRotatingScan(2, 5);
    scan->startAzimuth = -0.5;
    scan->azimuthSpan = 2;
    const RotatingGeometry geometry(*scan, rows(2));
    EXPECT_EQ(geometry.columns(), 5U);
    EXPECT_EQ(geometry.columnsPerFiring(), 1U);
    EXPECT_NEAR(geometry.azimuth(0), -0.5, rounding);
    EXPECT_NEAR(geometry.azimuth(3), 1.0, rounding);
    EXPECT_NEAR(geometry.azimuth(4), 1.5, rounding);
    scan->azimuthSpan = -2;
    EXPECT_NEAR(RotatingGeometry(*scan, rows(2)).azimuth(4), -2.5, rounding);
}

TEST(RotatingGeometry, singleColumnLooksAtTheStart) {
    const auto scan = test::emptyRotatingScan(2, 1);
    scan->startAzimuth = 0.7;
    scan->azimuthSpan = 2;
    const RotatingGeometry geometry(*scan, rows(2));
    EXPECT_EQ(geometry.azimuth(0), 0.7);
    EXPECT_EQ(geometry.time(0), scan->timestamp);
}

TEST(RotatingGeometry, pointIsRangeTimesDirection) {
    const auto scan = test::emptyRotatingScan(2, 8);
    SensorConfig config;
    config.elevations = {DEG2RAD(30.0), DEG2RAD(-90.0)};
    const RotatingGeometry geometry(*scan, config);
    const float tolerance = 4e-7F;  // 2 m in float: half a unit in the last place is 1.2e-7
    const auto left = geometry.point(0, 2, 1000);
    EXPECT_NEAR(left.x, 0, tolerance);
    EXPECT_NEAR(left.y, std::sqrt(3), tolerance);
    EXPECT_NEAR(left.z, 1, tolerance);
    const auto down = geometry.point(1, 5, 500);
    EXPECT_NEAR(down.x, 0, tolerance);
    EXPECT_NEAR(down.y, 0, tolerance);
    EXPECT_NEAR(down.z, -1, tolerance);
}

TEST(RotatingGeometry, velodyneWithPositiveSpanTurnsClockwise) {
    const auto scan = test::emptyRotatingScan(16, 9);
    scan->lidarModel = "VLP-16";
    scan->startAzimuth = 0.25;
    scan->azimuthSpan = 2;
    const auto azimuth = [&](AzimuthSense sense) {
        SensorConfig config;
        config.azimuthSense = sense;
        return RotatingGeometry(*scan, config).azimuth(4);
    };
    EXPECT_NEAR(azimuth(AzimuthSense::Auto), -1.25, rounding);
    EXPECT_NEAR(azimuth(AzimuthSense::Clockwise), -1.25, rounding);
    EXPECT_NEAR(azimuth(AzimuthSense::CounterClockwise), 1.25, rounding);
    scan->azimuthSpan = -2;  // as documented
    EXPECT_NEAR(azimuth(AzimuthSense::Auto), -0.75, rounding);
    scan->azimuthSpan = 2;
    scan->lidarModel = "SIMULATED";
    const RotatingGeometry other(*scan, rows(16));
    EXPECT_NEAR(other.azimuth(4), 1.25, rounding);
}

TEST(RotatingGeometry, stampTellsTheConfiguredMoment) {
    const auto scan = test::emptyRotatingScan(1, 5);
    scan->sweepDuration = 0.2;
    const auto milliseconds = [&](TimeReference reference, uint32_t column) {
        SensorConfig config = rows(1);
        config.timeReference = reference;
        const auto since = RotatingGeometry(*scan, config).time(column) - scan->timestamp;
        return std::chrono::duration<double, std::milli>(since).count();
    };
    constexpr double ticks = 2e-4;  // [ms] two clock ticks of 100 ns, each rounded down
    EXPECT_NEAR(milliseconds(TimeReference::First, 0), 0, ticks);
    EXPECT_NEAR(milliseconds(TimeReference::First, 3), 150, ticks);
    EXPECT_NEAR(milliseconds(TimeReference::Middle, 0), -100, ticks);
    EXPECT_NEAR(milliseconds(TimeReference::Last, 0), -200, ticks);
    EXPECT_NEAR(milliseconds(TimeReference::Last, 4), 0, ticks);
}

/// What MRPT makes of ten packets whose blocks are 0.4 degrees apart, from 1 degree on.
CObservationRotatingScan converted(uint8_t model, bool dual) {
    mrpt::obs::CObservationVelodyneScan packets;
    packets.calibration =
        mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model == 0x21 ? "HDL32" : "VLP16");
    for (size_t p = 0; p < 10; ++p) {
        auto packet = test::emptyVlp16Packet(static_cast<uint32_t>(1327 * p));
        packet.velodyne_model_ID = model;
        packet.laser_return_mode = dual ? 0x39 : 0x37;
        for (size_t b = 0; b < 12; ++b) {
            const size_t firing = dual ? 6 * p + b / 2 : 12 * p + b;
            test::setRotation(packet, b, static_cast<int>(100 + 40 * firing));
            for (size_t s = 0; s < 32; ++s) test::setReturn(packet, b, s, 1000, 9);
        }
        packets.scan_packets.push_back(packet);
    }
    CObservationRotatingScan scan;
    scan.fromVelodyne(packets);
    return scan;
}

struct Conversion {
    uint8_t model;
    bool dual;
    uint32_t columns, perFiring;  ///< columns in use, and those of a block or of a pair of blocks
};

class VelodyneConversion : public testing::TestWithParam<Conversion> {};

TEST_P(VelodyneConversion, columnsHaveTheAzimuthsOfTheirBlocks) {
    const Conversion expected = GetParam();
    CObservationRotatingScan scan = converted(expected.model, expected.dual);
    ASSERT_EQ(scan.columnCount, 3840) << "what MRPT 2.5.8 did";
    const RotatingGeometry geometry(scan, {});
    ASSERT_EQ(geometry.columns(), expected.columns);
    ASSERT_EQ(geometry.columnsPerFiring(), expected.perFiring);
    for (uint32_t c = 0; c < expected.columns; ++c) {
        const double block = c / expected.perFiring;
        EXPECT_NEAR(geometry.azimuth(c), -DEG2RAD(1 + 0.4 * block), rounding) << c;
    }
    // 1,327 us a packet, and as long for the last; to a tick of 100 ns.
    const std::chrono::duration<double, std::micro> lasts =
        geometry.time(expected.columns - expected.perFiring) - scan.timestamp;
    EXPECT_NEAR(lasts.count(), 13270 * (1 - double(expected.perFiring) / expected.columns), 0.1);

    // Nothing of it hangs on where returns are.
    scan.rangeImage.setZero(scan.rowCount, scan.columnCount);
    EXPECT_EQ(RotatingGeometry(scan, {}).azimuth(7), geometry.azimuth(7));
}

INSTANTIATE_TEST_SUITE_P(Models, VelodyneConversion,
                         testing::Values(Conversion{0x22, false, 240, 2},
                                         Conversion{0x22, true, 120, 2},
                                         Conversion{0x21, false, 120, 1},
                                         Conversion{0x21, true, 60, 1}));

TEST(RotatingGeometry, properVelodyneScanIsNotTrimmed) {
    // As many columns as five packets have returns, and none of them behind the first twentieth.
    const auto scan = test::emptyRotatingScan(16, 1920);
    scan->lidarModel = "VLP-16";
    scan->azimuthSpan = -2 * pi;
    for (int c = 0; c < 96; ++c) scan->rangeImage(3, c) = 1000;
    const RotatingGeometry geometry(*scan, {});
    EXPECT_EQ(geometry.columns(), 1920U);
    EXPECT_NEAR(geometry.azimuth(1919), -2 * pi, rounding);
}

TEST(RotatingGeometry, returnsBehindTheColumnsOfAConversionAreNotTrimmed) {
    CObservationRotatingScan scan = converted(0x22, false);
    scan.rangeImage(5, 240) = 1000;
    const RotatingGeometry geometry(scan, {});
    EXPECT_EQ(geometry.columns(), 3840U);
    EXPECT_NEAR(geometry.azimuth(3839), -DEG2RAD(1.0 + 48.0), rounding);
}

}  // namespace
}  // namespace offmap::rawlog
