// SPDX-License-Identifier: BSD-3-Clause
#include "../support/RotatingMaker.h"
#include "../support/Scans.h"
#include "../support/SweepMaker.h"
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/RangeSigma.h>
#include <offmap/rawlog/RotatingScan.h>
#include <offmap/rawlog/SelfMask.h>
#include <offmap/rawlog/SweepScan.h>
#include <offmap/rawlog/TurnReducer.h>
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

constexpr float unknown = 0.02F;  // [m]

SensorConfig withTable(std::vector<double> table) {
    SensorConfig config;
    config.rangeSigmaByIntensity = std::move(table);
    return config;
}

/// Sigma falls from 0.06 to 0.01 m between the intensities 0 and 1.
SensorConfig falling() { return withTable({0, 0.06, 1, 0.01}); }

/// Points 2 to 4 m ahead, of these intensities.
auto cloudOf(const std::vector<float>& intensities) {
    auto map = mrpt::maps::CPointsMapXYZI::Create();
    float x = 2;
    for (const float intensity : intensities) {
        map->insertPointRGB(x, 0, 0.1F * x, intensity, 0, 0);
        x += 0.5F;
    }
    auto cloud = std::make_shared<mrpt::obs::CObservationPointCloud>();
    cloud->pointcloud = map;
    return cloud;
}

TurnScan organized(const ScanClass& scanClass, const Turn& turn, const SensorConfig& config) {
    TurnScan out = scanClass.organize(turn, test::DrivenVehicle(CPose3D()), config);
    maskSelfReturns(out, config);
    findRangeSigmas(out, turn, scanClass, config, unknown);
    return out;
}

/// Of the slots, in their order.
std::vector<float> sigmasBySlot(const TurnScan& turn, size_t slots) {
    std::vector<float> sigmas(slots, -1);
    for (size_t i = 0; i < turn.scan.rangeSigma.size(); ++i) {
        sigmas.at(turn.scan.sourceIndex[i]) = turn.scan.rangeSigma[i];
    }
    return sigmas;
}

TEST(RangeSigma, isLinearBetweenThePairsAndConstantBeyond) {
    const std::vector<double> table = {0.1, 0.06, 0.3, 0.02, 0.5, 0.01};
    EXPECT_EQ(rangeSigmaAt(table, 0), 0.06);
    EXPECT_EQ(rangeSigmaAt(table, 0.1), 0.06);
    EXPECT_DOUBLE_EQ(rangeSigmaAt(table, 0.2), 0.04);
    EXPECT_EQ(rangeSigmaAt(table, 0.3), 0.02);
    EXPECT_DOUBLE_EQ(rangeSigmaAt(table, 0.35), 0.0175);
    EXPECT_EQ(rangeSigmaAt(table, 0.5), 0.01);
    EXPECT_EQ(rangeSigmaAt(table, 7), 0.01);
    EXPECT_EQ(rangeSigmaAt(std::vector{0.5, 0.03}, 0), 0.03);
}

TEST(RangeSigma, equalIntensitiesAreAStep) {
    const std::vector<double> step = {0.5, 0.06, 0.5, 0.01};
    EXPECT_EQ(rangeSigmaAt(step, 0.49), 0.06);
    EXPECT_EQ(rangeSigmaAt(step, 0.5), 0.01);
}

TEST(RangeSigma, ofACloudGoesByItsChannel) {
    const TurnScan turn = organized(PointCloudScan(), {cloudOf({0, 1, 0.5F})}, falling());
    EXPECT_THAT(sigmasBySlot(turn, 3),
                ElementsAre(FloatEq(0.06F), FloatEq(0.01F), FloatEq(0.035F)));
}

TEST(RangeSigma, ofACloudInWholeNumbersCounts255AsOne) {
    const TurnScan turn = organized(PointCloudScan(), {cloudOf({0, 255, 51})}, falling());
    EXPECT_THAT(sigmasBySlot(turn, 3), ElementsAre(FloatEq(0.06F), FloatEq(0.01F), FloatEq(0.05F)));
}

TEST(RangeSigma, isNotToldWithoutTableOrIntensities) {
    const auto cloud = cloudOf({0, 1});
    EXPECT_THAT(organized(PointCloudScan(), {cloud}, {}).scan.rangeSigma, IsEmpty());
    auto plain = std::make_shared<mrpt::obs::CObservationPointCloud>();
    plain->pointcloud = mrpt::maps::CSimplePointsMap::Create();
    plain->pointcloud->insertPoint(2, 0, 0);
    EXPECT_THAT(organized(PointCloudScan(), {plain}, falling()).scan.rangeSigma, IsEmpty());
    // A turn of both: the one that does not tell gets the usual sigma.
    const TurnScan turn = organized(PointCloudScan(), {plain, cloud}, falling());
    EXPECT_THAT(sigmasBySlot(turn, 3),
                ElementsAre(FloatEq(unknown), FloatEq(0.06F), FloatEq(0.01F)));
}

TEST(RangeSigma, staysWithItsPointWhereOthersAreTheRobotsOwn) {
    SensorConfig config = falling();
    config.minRange = 2.3;  // takes the first of three points
    const TurnScan turn = organized(PointCloudScan(), {cloudOf({0, 1, 0.5F})}, config);
    ASSERT_EQ(turn.scan.rangeSigma.size(), turn.scan.points.size());
    EXPECT_THAT(sigmasBySlot(turn, 3), ElementsAre(-1, FloatEq(0.01F), FloatEq(0.035F)));
}

// The maker's lasers tell 10, 11, 12 ... of 255.
TEST(RangeSigma, ofVelodynePacketsGoesByTheReturnsByte) {
    auto scan = std::make_shared<mrpt::obs::CObservationVelodyneScan>();
    scan->timestamp = mrpt::Clock::fromDouble(1.7e9);
    scan->calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
    test::fireVelodyne(*scan, test::vlp16Plan, 2,
                       [](double, const mrpt::math::TVector3D&) { return 5.0; });
    const TurnScan turn = organized(VelodyneScan(), {scan}, falling());
    ASSERT_EQ(turn.scan.rangeSigma.size(), 2U * slotsPerPacket);
    for (size_t i = 0; i < turn.scan.rangeSigma.size(); ++i) {
        const double intensity = (10 + turn.scan.sourceIndex[i] % 32) / 255.0;
        EXPECT_FLOAT_EQ(turn.scan.rangeSigma[i], static_cast<float>(0.06 - 0.05 * intensity));
    }
}

TEST(RangeSigma, ofARotatingScansOtherLayersIsTheUsual) {
    const auto scan = test::rotatingScanOf([](const auto&) { return 4.0; }, 36);
    test::addLastReturns(*scan);
    std::vector<double> elevations;
    for (const double degrees : test::rotatingElevations()) {
        elevations.push_back(mrpt::DEG2RAD(degrees));
    }
    SensorConfig config = falling();
    config.elevations = elevations;
    const TurnScan turn = organized(RotatingScan(), {scan}, config);
    const uint32_t cells = 32 * 36;
    size_t ofOtherLayer = 0;
    for (size_t i = 0; i < turn.scan.rangeSigma.size(); ++i) {
        const uint32_t slot = turn.scan.sourceIndex[i];
        const double intensity = (10 + slot / 36) / 255.0;
        const double expected = slot < cells ? 0.06 - 0.05 * intensity : double{unknown};
        EXPECT_FLOAT_EQ(turn.scan.rangeSigma[i], static_cast<float>(expected));
        ofOtherLayer += slot >= cells;
    }
    EXPECT_EQ(ofOtherLayer, 32U * 12) << "every third column";
}

TEST(RangeSigma, ofATurned2DScannerGoesByItsRays) {
    Turn turn;
    for (const double yaw : {0.0, 90.0}) {
        const auto fan = test::fanIn([](const auto&, const auto&) { return 3.0; },
                                     test::fanPose(yaw), {.aperture = 90, .rays = 3});
        fan->setScanHasIntensity(true);
        for (size_t i = 0; i < 3; ++i) fan->setScanIntensity(i, static_cast<int>(51 * i));
        turn.push_back(fan);
    }
    EXPECT_THAT(sigmasBySlot(organized(SweepScan(), turn, falling()), 6),
                ElementsAre(FloatEq(0.06F), FloatEq(0.05F), FloatEq(0.04F), FloatEq(0.06F),
                            FloatEq(0.05F), FloatEq(0.04F)));
}

// One return in front of the others by 0.2 m: with a table that takes that for noise, the column
// stays one segment.
TEST(RangeSigma, reachesTheReductionOfATurn) {
    auto cloud = cloudOf({});
    for (int i = 0; i < 20; ++i) {
        const float x = i == 10 ? 2.8F : 3.0F;
        cloud->pointcloud->insertPointRGB(x, 0, -1 + 0.1F * static_cast<float>(i), 0.5F, 0, 0);
    }
    const core::LineMap map({{{{3, -5}, {3, 5}}}});
    const test::DrivenVehicle poses{CPose3D()};
    const auto segmentsWith = [&](const std::vector<double>& table) {
        Config config;
        config.sensor.rangeSigmaByIntensity = table;
        TurnReducer reducer(map, poses, config, OutputClass::Same);
        return reducer.reduce({cloud}, PointCloudScan()).returnsPerSegment.size();
    };
    EXPECT_EQ(segmentsWith({}), 2U);
    EXPECT_EQ(segmentsWith({0.5, 0.1}), 1U);
}

TEST(RangeSigma, tableThatIsNoneIsRefused) {
    for (const std::vector<double>& bad :
         {std::vector{0.1}, {0.1, 0.02, 0.5}, {0.5, 0.02, 0.1, 0.03}, {0.1, 0.0}}) {
        EXPECT_THROW(withTable(bad).validate(), std::invalid_argument)
            << testing::PrintToString(bad);
    }
    EXPECT_NO_THROW(withTable({0.1, 0.02, 0.1, 0.03, 1, 0.01}).validate());
}

}  // namespace
}  // namespace offmap::rawlog
