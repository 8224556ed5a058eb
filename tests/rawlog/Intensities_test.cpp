// SPDX-License-Identifier: BSD-3-Clause
#include "../support/DepthCameraMaker.h"
#include "../support/RotatingMaker.h"
#include "../support/Scans.h"
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/Intensities.h>
#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/RangeImageScan.h>
#include <offmap/rawlog/RotatingScan.h>
#include <offmap/rawlog/VelodynePackets.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <cmath>

namespace offmap::rawlog {
namespace {

using mrpt::poses::CPose3D;
using testing::ElementsAre;
using testing::FloatEq;
using testing::IsEmpty;
using testing::NanSensitiveFloatEq;

std::vector<float> ofPoints(const ScanClass& scanClass, const Turn& turn) {
    const TurnScan scan = scanClass.organize(turn, test::DrivenVehicle(CPose3D()), {});
    return pointIntensitiesOf(turn, scanClass, scan.scan);
}

std::shared_ptr<mrpt::obs::CObservationPointCloud> cloudOn(mrpt::maps::CPointsMap::Ptr map) {
    auto cloud = std::make_shared<mrpt::obs::CObservationPointCloud>();
    cloud->pointcloud = std::move(map);
    return cloud;
}

// The upper point comes first in the cloud, the lower one in the column.
TEST(Intensities, followThePointsOfTheScan) {
    auto map = mrpt::maps::CPointsMapXYZI::Create();
    map->insertPointRGB(2, 0, 1, 0.75F, 0, 0);
    map->insertPointRGB(2, 0, 0, 0.25F, 0, 0);
    const Turn turn{cloudOn(map)};
    EXPECT_THAT(ofPoints(PointCloudScan(), turn), ElementsAre(0.25F, 0.75F));
    EXPECT_THAT(slotIntensitiesOf(turn, PointCloudScan()), ElementsAre(0.75F, 0.25F));
}

TEST(Intensities, areNoneWhereNoObservationTellsAny) {
    auto bare = mrpt::maps::CSimplePointsMap::Create();
    bare->insertPoint(2, 0, 0);
    EXPECT_THAT(ofPoints(PointCloudScan(), {cloudOn(bare)}), IsEmpty());
    auto bright = mrpt::maps::CPointsMapXYZI::Create();
    bright->insertPointRGB(2, 0, 0, 0.5F, 0, 0);
    EXPECT_THAT(slotIntensitiesOf({cloudOn(bare), cloudOn(bright)}, PointCloudScan()),
                ElementsAre(NanSensitiveFloatEq(std::nanf("")), FloatEq(0.5F)));
}

TEST(Intensities, ofPacketsCountTo255) {
    auto obs = std::make_shared<mrpt::obs::CObservationVelodyneScan>();
    obs->scan_packets.push_back(test::emptyVlp16Packet(0));
    test::setReturn(obs->scan_packets[0], 0, 3, 1000, 51);
    const auto slots = slotIntensitiesOf({obs}, VelodyneScan());
    ASSERT_EQ(slots.size(), VelodyneScan().slotCount(*obs));
    EXPECT_FLOAT_EQ(slots[3], 0.2F);
    EXPECT_EQ(slots[4], 0);
}

TEST(Intensities, ofRotatingScansStandInTheirImage) {
    const auto obs = test::emptyRotatingScan(2, 3);
    obs->intensityImage.setSize(2, 3);
    obs->intensityImage.fill(0);
    obs->intensityImage(1, 2) = 255;
    EXPECT_THAT(slotIntensitiesOf({obs}, RotatingScan()), ElementsAre(0, 0, 0, 0, 0, 1));
}

std::shared_ptr<test::DepthImage> depthImageWith(const mrpt::img::CImage& intensities) {
    auto obs = test::emptyDepthImage(2, 1);
    obs->hasIntensityImage = true;
    obs->intensityImage = intensities;
    obs->cameraParamsIntensity = obs->cameraParams;
    return obs;
}

TEST(Intensities, ofDepthCamerasAreTheBrightnessOfTheirPixels) {
    mrpt::img::CImage grey(2, 1, mrpt::img::CH_GRAY);
    *grey.ptr<uint8_t>(0, 0) = 51;
    *grey.ptr<uint8_t>(1, 0) = 255;
    EXPECT_THAT(brightnessOf(*depthImageWith(grey)), ElementsAre(FloatEq(0.2F), FloatEq(1)));
    mrpt::img::CImage colour(2, 1, mrpt::img::CH_RGB);
    colour.setPixel(0, 0, mrpt::img::TColor(0, 255, 0));
    colour.setPixel(1, 0, mrpt::img::TColor(255, 255, 255));
    // Rec. 601: green makes 58.7 % of what is bright.
    EXPECT_THAT(brightnessOf(*depthImageWith(colour)), ElementsAre(FloatEq(0.587F), FloatEq(1)));
    const auto obs = depthImageWith(grey);
    obs->rangeImage(0, 0) = 0;
    obs->rangeImage(0, 1) = 2000;  // the only return
    EXPECT_THAT(ofPoints(RangeImageScan(), {obs}), ElementsAre(1));
    EXPECT_THAT(slotIntensitiesOf({obs}, RangeImageScan()), IsEmpty())
        << "it tells nothing of ranges";
}

TEST(Intensities, ofDepthCamerasWithAnotherImageAreNone) {
    mrpt::img::CImage larger(4, 2, mrpt::img::CH_GRAY);
    EXPECT_THAT(brightnessOf(*depthImageWith(larger)), IsEmpty());
    EXPECT_THAT(brightnessOf(*test::emptyDepthImage(2, 1)), IsEmpty());
}

}  // namespace
}  // namespace offmap::rawlog
