// SPDX-License-Identifier: BSD-3-Clause
#include "../support/SimulatedRobot.h"

#include <offmap/rawlog/SensorModel.h>

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationRotatingScan.h>

namespace {

using namespace offmap::rawlog;
using offmap::test::SimulatedRobot;

TEST(SensorModel, velodyneTellsModelAndReturnMode) {
    auto scan = SimulatedRobot().vlp16(1);
    EXPECT_EQ(sensorModelOf(*scan), (SensorModel{"VLP-16", "strongest return"}));
    scan->scan_packets[0].velodyne_model_ID = 0x21;
    scan->scan_packets[0].laser_return_mode = 0x39;
    EXPECT_EQ(sensorModelOf(*scan), (SensorModel{"HDL-32E", "dual return"}));
    scan->scan_packets[0].velodyne_model_ID = 0x99;
    scan->scan_packets[0].laser_return_mode = 0;
    EXPECT_EQ(sensorModelOf(*scan), (SensorModel{"Velodyne model 0x99", "return mode not known"}));
    scan->calibration.laser_corrections.resize(64);
    EXPECT_EQ(sensorModelOf(*scan).name, "HDL-64E");
    scan->scan_packets.clear();
    EXPECT_EQ(sensorModelOf(*scan).details, "no packets");
}

TEST(SensorModel, flatScannersTellHowTheyAreMounted) {
    SimulatedRobot robot;
    EXPECT_EQ(sensorModelOf(*robot.horizontalScan()),
              (SensorModel{"2D scanner, level", "181 rays over 180 deg"}));
    EXPECT_EQ(sensorModelOf(*robot.sweep(4).front()).name, "2D scanner, upright");
}

TEST(SensorModel, cloudTellsItsMap) {
    const auto cloud = SimulatedRobot().cloud();
    EXPECT_EQ(sensorModelOf(*cloud), (SensorModel{"point cloud", "CPointsMapXYZI"}));
    cloud->pointcloud.reset();
    EXPECT_EQ(sensorModelOf(*cloud), (SensorModel{"point cloud", "no points"}));
}

TEST(SensorModel, imagesTellTheirSize) {
    mrpt::obs::CObservation3DRangeScan depth;
    depth.hasRangeImage = depth.hasIntensityImage = true;
    depth.cameraParams.ncols = 640;
    depth.cameraParams.nrows = 480;
    EXPECT_EQ(sensorModelOf(depth), (SensorModel{"depth camera", "640 x 480 pixels, image"}));
    mrpt::obs::CObservationRotatingScan rotating;
    rotating.rowCount = 16;
    rotating.columnCount = 900;
    rotating.lidarModel = "VLP-16";
    EXPECT_EQ(sensorModelOf(rotating), (SensorModel{"VLP-16", "16 rows x 900 columns"}));
}

TEST(SensorModel, whatIsNoScannerHasNone) {
    EXPECT_EQ(sensorModelOf(*SimulatedRobot().imu()), SensorModel{});
}

}  // namespace
