// SPDX-License-Identifier: BSD-3-Clause
#include "../support/DepthCameraMaker.h"
#include "../support/Scans.h"

#include <offmap/rawlog/RangeImageScan.h>
#include <offmap/rawlog/ScanClasses.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <limits>

namespace offmap::rawlog {
namespace {

using mrpt::poses::CPose3D;
using test::DepthImage;
using test::emptyDepthImage;
using testing::HasSubstr;

const char* const rgbdSample = "/usr/share/mrpt/datasets/tests_rgbd.rawlog";

/// A wall 2 m ahead that leans a little, so that no two ranges of a column are equal; every 7th
/// pixel without return.
std::shared_ptr<DepthImage> slopingWall(bool rangeIsDepth = true) {
    auto obs = emptyDepthImage();
    obs->range_is_depth = rangeIsDepth;
    int pixel = 0;
    test::fillDepths(*obs, [&](const mrpt::math::TVector3D& direction) {
        return ++pixel % 7 == 0 ? 0 : 2.0 / (1.0 + 0.1 * direction.z);
    });
    return obs;
}

TurnScan organized(const DepthImage& obs, const SensorConfig& config = {}) {
    return RangeImageScan().organize({std::make_shared<DepthImage>(obs)},
                                     test::DrivenVehicle(CPose3D()), config);
}

/// Every point of a scan by its slot; the origin where there is none.
std::vector<mrpt::math::TPoint3Df> pointsBySlot(const TurnScan& turn, size_t slots) {
    std::vector<mrpt::math::TPoint3Df> points(slots);
    for (size_t i = 0; i < turn.scan.points.size(); ++i) {
        points[turn.scan.sourceIndex[i]] = turn.scan.points[i];
    }
    return points;
}

/// [m] 2 ulp of 5 m: the products are the same, their order is not.
constexpr float rounding = 1e-6F;

void expectAsUnprojected(const DepthImage& obs, const TurnScan& turn) {
    DepthImage oracle = obs;
    test::storePoints(oracle, true);
    const auto points = pointsBySlot(turn, RangeImageScan().slotCount(obs));
    ASSERT_EQ(oracle.points3D_x.size(), points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        ASSERT_NEAR(points[i].x, oracle.points3D_x[i], rounding) << i;
        ASSERT_NEAR(points[i].y, oracle.points3D_y[i], rounding) << i;
        ASSERT_NEAR(points[i].z, oracle.points3D_z[i], rounding) << i;
    }
}

TEST(RangeImageScan, pointsAreThoseThatMrptUnprojects) {
    for (const bool rangeIsDepth : {true, false}) {
        auto obs = *slopingWall(rangeIsDepth);
        obs.sensorPose = CPose3D(1, 2, 3, 0.4, 0.01, 0);  // not in the points, nor in the slots
        expectAsUnprojected(obs, organized(obs));
        obs.cameraParams.setDistortionPlumbBob(-0.05, 0.01, 0.001, 0.002);
        expectAsUnprojected(obs, organized(obs));
    }
}

TEST(RangeImageScan, onePixelIsWhereItLooks) {
    DepthImage obs = *emptyDepthImage(8, 8);
    obs.cameraParams.setIntrinsicParamsFromValues(4, 8, 3, 4);
    obs.rangeUnits = 0.002F;
    obs.rangeImage(2, 7) = 1000;  // 2 m ahead, (3 - 7) / 4 to the left, (4 - 2) / 8 up
    const TurnScan turn = organized(obs);
    ASSERT_EQ(turn.scan.points.size(), 1U);
    EXPECT_NEAR(turn.scan.points[0].x, 2.0, rounding);
    EXPECT_NEAR(turn.scan.points[0].y, -2.0, rounding);
    EXPECT_NEAR(turn.scan.points[0].z, 0.5, rounding);
    EXPECT_EQ(turn.scan.sourceIndex[0], 2U * 8 + 7);
    EXPECT_EQ(turn.counts.returns, 1U);
    EXPECT_EQ(turn.counts.zero, 63U);
}

TEST(RangeImageScan, equalRangeOfAnotherLayerIsTheSameReturn) {
    DepthImage obs = *emptyDepthImage(8, 4);
    obs.rangeImage.fill(1000);
    // As MRPT reads a layer: rows and columns exchanged.
    auto& last = obs.rangeImageOtherLayers["LAST"];
    last.setSize(8, 4);
    std::fill_n(last.data(), 32, uint16_t{1000});
    last.data()[2 * 8 + 5] = 3000;
    auto& middle = obs.rangeImageOtherLayers["MIDDLE"];
    middle.setSize(4, 8);
    middle.fill(0);
    middle(2, 5) = 3000;
    middle(0, 0) = 2000;
    const TurnScan turn = organized(obs);
    EXPECT_EQ(turn.counts.returns, 32U + 32U + 2U);
    EXPECT_EQ(turn.counts.zero, 30U);
    EXPECT_EQ(turn.counts.duplicates, 31U + 1U);
    ASSERT_EQ(turn.scan.columns.size(), 8U + 1U + 1U);
    EXPECT_EQ(turn.scan.sourceIndex[32], 32U + 2 * 8 + 5) << "its own column, behind the others";
    EXPECT_EQ(turn.scan.columns[8].azimuth, turn.scan.columns[5].azimuth);
    EXPECT_EQ(turn.scan.sourceIndex[33], 64U);
    for (const DuplicateReturn& duplicate : turn.duplicates) {
        EXPECT_EQ(duplicate.slot % 32, turn.scan.sourceIndex[duplicate.point] % 32);
    }

    std::vector<uint8_t> keep(96, 1);
    keep[32 + 2 * 8 + 5] = 0;
    const auto kept = RangeImageScan().withOnly(obs, keep);
    auto& layers = dynamic_cast<DepthImage&>(*kept).rangeImageOtherLayers;
    EXPECT_EQ(layers["LAST"].data()[2 * 8 + 5], 0);
    EXPECT_EQ(std::count(layers["LAST"].data(), layers["LAST"].data() + 32, 1000), 31);
    EXPECT_EQ(layers["MIDDLE"](2, 5), 3000);
}

TEST(RangeImageScan, keepingAllIsTheOriginal) {
    DepthImage obs = *slopingWall();
    test::storePoints(obs);
    obs.rangeImageOtherLayers["LAST"] = obs.rangeImage;
    const std::vector<uint8_t> all(RangeImageScan().slotCount(obs), 1);
    EXPECT_EQ(test::bytesOf(*RangeImageScan().withOnly(obs, all)), test::bytesOf(obs));
}

TEST(RangeImageScan, keptAndRemovedTogetherAreTheOriginal) {
    DepthImage obs = *slopingWall();
    obs.rangeImageOtherLayers["LAST"] = obs.rangeImage;
    const std::string before = test::bytesOf(obs);
    for (uint32_t seed = 1; seed <= 5; ++seed) {
        const auto keep = test::randomMask(RangeImageScan().slotCount(obs), seed);
        auto kept = RangeImageScan().withOnly(obs, keep);
        const auto removed = RangeImageScan().withOnly(obs, test::complementOf(keep));
        auto& joined = dynamic_cast<DepthImage&>(*kept);
        auto& other = dynamic_cast<DepthImage&>(*removed);
        const auto pixels = static_cast<size_t>(obs.rangeImage.size());
        for (size_t i = 0; i < pixels; ++i) {
            EXPECT_EQ(joined.rangeImage.data()[i] != 0, keep[i] && obs.rangeImage.data()[i] != 0);
            joined.rangeImage.data()[i] += other.rangeImage.data()[i];
            joined.rangeImageOtherLayers["LAST"].data()[i] +=
                other.rangeImageOtherLayers["LAST"].data()[i];
        }
        EXPECT_EQ(test::bytesOf(joined), before);
    }
    EXPECT_EQ(test::bytesOf(obs), before) << "the original was changed";
}

TEST(RangeImageScan, storedPointsAloneAreSlots) {
    DepthImage obs = *slopingWall();
    test::storePoints(obs);
    const TurnScan image = organized(obs);
    obs.hasRangeImage = false;
    const TurnScan points = organized(obs);
    EXPECT_EQ(RangeImageScan().slotCount(obs), obs.points3D_x.size());
    EXPECT_EQ(points.counts.returns, image.counts.returns);
    const auto keep = test::randomMask(obs.points3D_x.size(), 3);
    const auto reduced = RangeImageScan().withOnly(obs, keep);
    const auto& kept = dynamic_cast<const DepthImage&>(*reduced);
    const auto expected = static_cast<size_t>(std::ranges::count(keep, 1));
    EXPECT_EQ(kept.points3D_z.size(), expected);
    EXPECT_EQ(kept.points3D_idxs_y.size(), expected);
}

TEST(RangeImageScan, cloudHoldsTheChosenReturns) {
    DepthImage obs = *slopingWall();
    obs.sensorLabel = "DEPTH";
    const auto keep = test::randomMask(RangeImageScan().slotCount(obs), 5);
    const auto cloud = RangeImageScan().asPointCloud(obs, keep, {});
    mrpt::maps::CSimplePointsMap oracle;
    mrpt::obs::T3DPointsProjectionParams parameters;
    parameters.takeIntoAccountSensorPoseOnRobot = false;
    auto reduced = std::dynamic_pointer_cast<DepthImage>(RangeImageScan().withOnly(obs, keep));
    reduced->unprojectInto(oracle, parameters);
    const auto& map = *dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*cloud).pointcloud;
    EXPECT_EQ(cloud->sensorLabel, "DEPTH");
    ASSERT_EQ(map.size(), oracle.size());
    for (size_t i = 0; i < map.size(); ++i) {
        float x = 0, y = 0, z = 0, u = 0, v = 0, w = 0;
        map.getPoint(i, x, y, z);
        oracle.getPoint(i, u, v, w);
        EXPECT_NEAR(x, u, rounding);
        EXPECT_NEAR(y, v, rounding);
        EXPECT_NEAR(z, w, rounding);
    }
}

TEST(RangeImageScan, whatCannotBeReducedIsNamed) {
    const auto expectReason = [](const char* reason, auto&& spoil) {
        DepthImage obs = *slopingWall();
        spoil(obs);
        EXPECT_EQ(scanClassOf(obs, {}), nullptr);
        const auto found = unsupportedReason(obs, {});
        ASSERT_TRUE(found) << reason;
        EXPECT_THAT(*found, testing::AllOf(HasSubstr(reason), HasSubstr("copied unchanged")));
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    expectReason("fx 0", [](auto& obs) { obs.cameraParams.fx(0); });
    expectReason("fy nan", [](auto& obs) { obs.cameraParams.fy(nan); });
    expectReason("calibration", [](auto& obs) { obs.cameraParams.dist[2] = nan; });
    expectReason("fisheye", [](auto& obs) {
        obs.cameraParams.distortion = mrpt::img::DistortionModel::kannala_brandt;
    });
    expectReason("rangeUnits is 0", [](auto& obs) { obs.rangeUnits = 0; });
    expectReason("rangeUnits is -1", [](auto& obs) { obs.rangeUnits = -1; });
    expectReason("rangeUnits is nan", [](auto& obs) { obs.rangeUnits = nan; });
    expectReason("640 x 120 pixels", [](auto& obs) { obs.cameraParams.ncols = 640; });
    expectReason("layer 'LAST' has 3 x 2",
                 [](auto& obs) { obs.rangeImageOtherLayers["LAST"].setSize(2, 3); });
    expectReason("neither", [](auto& obs) { obs.hasRangeImage = false; });
    expectReason("neither", [](auto& obs) { obs.rangeImage.setSize(0, 0); });
    expectReason("lack coordinates", [](auto& obs) {
        obs.hasPoints3D = true;
        obs.points3D_x = {1.0F};
    });
}

TEST(RangeImageScan, realImageKeepsItsReturns) {
    const auto obs = test::observationsIn<DepthImage>(rgbdSample).at(0);
    const TurnScan turn = organized(*obs);
    EXPECT_EQ(turn.scan.columns.size(), 640U);
    EXPECT_EQ(turn.counts.returns, 273'225U);
    EXPECT_EQ(turn.counts.zero, 640U * 480 - 273'225);
    EXPECT_EQ(turn.counts.duplicates, 0U);
    expectAsUnprojected(*obs, turn);
}

}  // namespace
}  // namespace offmap::rawlog
