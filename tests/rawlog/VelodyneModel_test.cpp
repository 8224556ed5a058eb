// SPDX-License-Identifier: BSD-3-Clause
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/VelodyneModel.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace offmap::rawlog {
namespace {

using testing::HasSubstr;
using Scan = mrpt::obs::CObservationVelodyneScan;

Scan scanOf(std::vector<test::VelodynePacket> packets) {
    Scan scan;
    scan.scan_packets = std::move(packets);
    return scan;
}

Scan hdl64() {
    Scan scan = scanOf({test::emptyHdl64Packet(0), test::emptyHdl64Packet(288)});
    scan.calibration = test::hdl64Calibration();
    return scan;
}

void expectRefusal(const Scan& scan, const char* why) {
    const auto reason = unsupportedVelodyne(scan);
    ASSERT_TRUE(reason) << why;
    EXPECT_THAT(*reason, HasSubstr(why));
    EXPECT_THAT(*reason, HasSubstr("is not supported, copied unchanged"));
    EXPECT_THROW(modelOf(scan), std::invalid_argument);
}

TEST(VelodyneModel, packetsTellTheirModel) {
    EXPECT_EQ(modelOf(scanOf({test::emptyVlp16Packet(0)})).name, "VLP-16");
    EXPECT_EQ(modelOf(scanOf({test::emptyHdl32Packet(0)})).name, "HDL-32E");
    EXPECT_FALSE(unsupportedVelodyne(scanOf({})));
}

// Its status byte says 0x22, as a VLP-16 does.
TEST(VelodyneModel, hdl64IsKnownByItsLowerBank) {
    EXPECT_EQ(modelOf(hdl64()).name, "HDL-64E");
    EXPECT_EQ(calibrationOf(hdl64(), modelOf(hdl64())).size(), 64U);
}

TEST(VelodyneModel, hdl64NeedsItsCalibration) {
    Scan scan = hdl64();
    scan.calibration.clear();
    expectRefusal(scan, "HDL-64E without its calibration of 64 lasers");
    scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("HDL32");
    expectRefusal(scan, "HDL-64E without its calibration of 64 lasers");
}

TEST(VelodyneModel, fewDamagedHeadersMakeNoHdl64) {
    auto packet = test::emptyVlp16Packet(0);
    for (size_t b = 0; b < 3; ++b) test::setHeader(packet, b, test::lowerBank);
    EXPECT_EQ(modelOf(scanOf({packet})).name, "VLP-16");
}

TEST(VelodyneModel, mixedAndUnknownModelsAreRefused) {
    expectRefusal(scanOf({test::emptyVlp16Packet(0), test::emptyHdl32Packet(0)}),
                  "packets of both VLP-16 and HDL-32E");
    auto packet = test::emptyVlp16Packet(0);
    packet.velodyne_model_ID = 0x28;
    expectRefusal(scanOf({packet}), "Velodyne model 0x28");
}

TEST(VelodyneModel, calibrationThatDoesNotFitIsRefused) {
    Scan scan = scanOf({test::emptyVlp16Packet(0)});
    scan.calibration.laser_corrections.resize(64);
    expectRefusal(scan, "a Velodyne calibration of 64 lasers for a VLP-16");
    scan = scanOf({test::emptyHdl32Packet(0)});
    scan.calibration.laser_corrections.resize(16);
    expectRefusal(scan, "a Velodyne calibration of 16 lasers for a HDL-32E");
}

TEST(VelodyneModel, senselessCalibrationIsRefused) {
    Scan scan = hdl64();
    scan.calibration.laser_corrections[5].distanceCorrection =
        std::numeric_limits<double>::quiet_NaN();
    expectRefusal(scan, "not finite (laser 5)");
    scan = hdl64();
    scan.calibration.laser_corrections[63].azimuthCorrection = -31;
    expectRefusal(scan, "azimuth correction of -31 degrees");
}

TEST(VelodyneModel, defaultCalibrationsHaveNoAzimuthCorrections) {
    for (const auto& packet : {test::emptyVlp16Packet(0), test::emptyHdl32Packet(0)}) {
        const Scan scan = scanOf({packet});
        const VelodyneModel& model = modelOf(scan);
        ASSERT_EQ(calibrationOf(scan, model).size(), model.lasers);
        for (const auto& laser : calibrationOf(scan, model)) {
            EXPECT_EQ(laser.azimuthCorrection + 0.0, 0.0);
        }
    }
}

}  // namespace
}  // namespace offmap::rawlog
