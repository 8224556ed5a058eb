// SPDX-License-Identifier: BSD-3-Clause
#include "../support/RotatingMaker.h"
#include "../support/SweepMaker.h"
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/RotatingScan.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/SweepScan.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationPointCloud.h>

namespace offmap::rawlog {
namespace {

using mrpt::obs::CObservationVelodyneScan;
using testing::ContainsRegex;
using testing::HasSubstr;

CObservationVelodyneScan vlp16() {
    CObservationVelodyneScan scan;
    scan.scan_packets = {test::emptyVlp16Packet(0), test::emptyVlp16Packet(1327)};
    return scan;
}

void expectUnsupported(const mrpt::obs::CObservation& obs, const char* what) {
    EXPECT_EQ(scanClassOf(obs, {}), nullptr);
    const auto reason = unsupportedReason(obs, {});
    ASSERT_TRUE(reason);
    EXPECT_THAT(*reason, HasSubstr(what));
    EXPECT_THAT(*reason, ContainsRegex("not supported.*copied unchanged"));
}

TEST(ScanClasses, supportedObservationsHaveTheirClass) {
    EXPECT_TRUE(dynamic_cast<const VelodyneScan*>(scanClassOf(vlp16(), {})));
    EXPECT_TRUE(dynamic_cast<const VelodyneScan*>(scanClassOf(CObservationVelodyneScan(), {})));
    EXPECT_TRUE(
        dynamic_cast<const PointCloudScan*>(scanClassOf(mrpt::obs::CObservationPointCloud(), {})));
    const auto fan = test::fanWithoutReturns(test::fanPose(10));
    EXPECT_TRUE(dynamic_cast<const SweepScan*>(scanClassOf(*fan, {})));
    const auto rotating = test::emptyRotatingScan(2, 8);
    const SensorConfig twoRows = test::withElevations({0.1, 0});
    EXPECT_TRUE(dynamic_cast<const RotatingScan*>(scanClassOf(*rotating, twoRows)));
    EXPECT_FALSE(unsupportedReason(*rotating, twoRows));
    EXPECT_FALSE(unsupportedReason(vlp16(), {}));
    EXPECT_FALSE(unsupportedReason(*fan, {}));
}

TEST(ScanClasses, levelScansAndImagesHaveNone) {
    const mrpt::obs::CObservation2DRangeScan level;
    EXPECT_EQ(scanClassOf(level, {}), nullptr);
    EXPECT_FALSE(unsupportedReason(level, {}));
    const mrpt::obs::CObservationImage image;
    EXPECT_EQ(scanClassOf(image, {}), nullptr);
    EXPECT_FALSE(unsupportedReason(image, {}));
}

TEST(ScanClasses, rotatingScanNeedsItsElevations) {
    const auto scan = test::emptyRotatingScan(2, 8);
    EXPECT_EQ(scanClassOf(*scan, {}), nullptr);
    EXPECT_THAT(unsupportedReason(*scan, {}).value_or(""), HasSubstr("sensor.elevations_deg"));
}

TEST(ScanClasses, unknownVelodyneIsNamed) {
    auto scan = vlp16();
    scan.scan_packets[1].velodyne_model_ID = 0x28;
    expectUnsupported(scan, "0x28");
}

TEST(ScanClasses, velodyneCloudWithoutPacketsIsNamed) {
    CObservationVelodyneScan scan;
    scan.point_cloud.x = scan.point_cloud.y = scan.point_cloud.z = {1.0F};
    expectUnsupported(scan, "without its packets");
}

}  // namespace
}  // namespace offmap::rawlog
