// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SharedData.h"

#include <offmap/rawlog/PointCloudScan.h>

#include <gtest/gtest.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/maps/CWeightedPointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace offmap::rawlog {
namespace {

using Cloud = mrpt::obs::CObservationPointCloud;
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

Cloud cloudOf(const std::vector<TPoint3Df>& points) {
    Cloud cloud;
    cloud.pointcloud = mrpt::maps::CSimplePointsMap::Create();
    for (const auto& p : points) cloud.pointcloud->insertPoint(p.x, p.y, p.z);
    return cloud;
}

std::vector<TPoint3Df> realPoints() {
    const auto cloud =
        test::observationsIn<Cloud>(test::sharedData("room/room1_points.rawlog")).at(0);
    std::vector<TPoint3Df> points(cloud->pointcloud->size());
    for (size_t i = 0; i < points.size(); ++i) {
        cloud->pointcloud->getPointFast(i, points[i].x, points[i].y, points[i].z);
    }
    return points;
}

TurnScan organized(const Cloud& cloud, const SensorConfig& config = {}) {
    return PointCloudScan().organize({std::make_shared<Cloud>(cloud)},
                                     test::DrivenVehicle(CPose3D()), config);
}

TEST(PointCloudScan, columnsStandBottomToTop) {
    const TurnScan turn = organized(cloudOf({{1, 0, 2}, {0, 1, 0}, {1, 0, -1}, {1, 0, 0}}));
    ASSERT_EQ(turn.scan.columns.size(), 2U);
    EXPECT_EQ(turn.scan.sourceIndex, (std::vector<uint32_t>{2, 3, 0, 1}));
    // Bins of 2 degrees.
    EXPECT_NEAR(turn.scan.columns[0].azimuth, 0, mrpt::DEG2RAD(1.0) + 1e-6);
    EXPECT_NEAR(turn.scan.columns[1].azimuth, mrpt::DEG2RAD(90.0), mrpt::DEG2RAD(1.0) + 1e-6);
}

TEST(PointCloudScan, orderOfThePointsChangesOnlyTheirSlots) {
    OFFMAP_NEEDS_SHARED_DATA()
    auto points = realPoints();
    const TurnScan turn = organized(cloudOf(points));
    std::vector<uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    std::vector<TPoint3Df> shuffled;
    for (const uint32_t i : order) shuffled.push_back(points[i]);
    const TurnScan other = organized(cloudOf(shuffled));

    EXPECT_EQ(other.scan.points, turn.scan.points);
    ASSERT_EQ(other.scan.columns.size(), turn.scan.columns.size());
    for (size_t c = 0; c < turn.scan.columns.size(); ++c) {
        EXPECT_EQ(other.scan.columns[c].begin, turn.scan.columns[c].begin);
        EXPECT_EQ(other.scan.columns[c].end, turn.scan.columns[c].end);
        EXPECT_EQ(other.scan.columns[c].azimuth, turn.scan.columns[c].azimuth);
    }
    for (size_t i = 0; i < other.scan.points.size(); ++i) {
        EXPECT_EQ(shuffled[other.scan.sourceIndex[i]], other.scan.points[i]);
    }
}

TEST(PointCloudScan, whatIsNoReturnIsCountedAndLeftOut) {
    const TurnScan turn = organized(
        cloudOf({{1, 0, 0}, {nan, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, inf, 0}, {1, 0, 0.5F}}));
    EXPECT_EQ(turn.scan.sourceIndex, (std::vector<uint32_t>{0, 5}));
    EXPECT_EQ(turn.counts.returns, 3U);
    EXPECT_EQ(turn.counts.duplicates, 1U);
    ASSERT_EQ(turn.duplicates.size(), 1U);
    EXPECT_EQ(turn.duplicates[0].slot, 3U);
    EXPECT_EQ(turn.duplicates[0].point, 0U);
    EXPECT_EQ(turn.counts.nonFinite, 2U);
    EXPECT_EQ(turn.counts.zero, 1U);
}

TEST(PointCloudScan, cloudWithoutPointsHasNoColumns) {
    EXPECT_TRUE(organized(cloudOf({})).scan.columns.empty());
    EXPECT_TRUE(organized(Cloud()).scan.columns.empty());  // not even a map of points
    EXPECT_EQ(PointCloudScan().withOnly(Cloud(), {})->GetRuntimeClass(),
              CLASS_ID(mrpt::obs::CObservationPointCloud));
}

TEST(PointCloudScan, mountingTurnsAzimuthAndTurnsItOver) {
    Cloud cloud = cloudOf({{3, 0, 1}, {3, 0, -1}});
    cloud.sensorPose = CPose3D(0, 0, 2, mrpt::DEG2RAD(90.0), 0, mrpt::DEG2RAD(180.0));
    const TurnScan turn = organized(cloud);
    ASSERT_EQ(turn.scan.columns.size(), 1U);
    // Half a column off at most.
    EXPECT_NEAR(turn.scan.columns[0].azimuth, mrpt::DEG2RAD(90.0), mrpt::DEG2RAD(1.0) + 1e-6);
    EXPECT_EQ(turn.scan.sourceIndex, (std::vector<uint32_t>{0, 1}));  // z down in the vehicle
    ASSERT_TRUE(turn.scan.columns[0].sensor);
    EXPECT_DOUBLE_EQ(turn.scan.columns[0].sensor->sensorInMap.z(), 2.0);
}

/// A cloud with all the channels of its class and with options off their defaults.
template <class Map>
Cloud fullCloud(size_t size) {
    auto map = Map::Create();
    map->insertionOptions.minDistBetweenLaserPoints = 0.123F;
    map->likelihoodOptions.sigma_dist = 0.456;
    map->renderOptions.point_size = 7.0F;
    map->genericMapParams.enableObservationInsertion = false;
    map->resize(size);
    std::vector<float> fields;
    map->getPointAllFieldsFast(0, fields);
    for (size_t i = 0; i < size; ++i) {
        for (size_t f = 0; f < fields.size(); ++f) {
            fields[f] = 0.001F * static_cast<float>(i * fields.size() + f);
            if (std::is_same_v<Map, mrpt::maps::CWeightedPointsMap> && f == 3) {
                fields[f] = static_cast<float>(i);
            }
        }
        map->setPointAllFieldsFast(i, fields);
    }
    map->mark_as_modified();
    Cloud cloud;
    cloud.sensorLabel = "LIDAR";
    cloud.timestamp = mrpt::Clock::fromDouble(1.7e9);
    cloud.sensorPose = CPose3D(1, 2, 3, 0.1, 0.2, 0.3);
    cloud.pointcloud = map;
    return cloud;
}

template <class Map>
class PointCloudScanOf : public testing::Test {};
using MapClasses = testing::Types<mrpt::maps::CSimplePointsMap, mrpt::maps::CPointsMapXYZI,
                                  mrpt::maps::CColouredPointsMap, mrpt::maps::CWeightedPointsMap>;
TYPED_TEST_SUITE(PointCloudScanOf, MapClasses);

TYPED_TEST(PointCloudScanOf, keepingAllIsTheOriginal) {
    const Cloud cloud = fullCloud<TypeParam>(50);
    const auto same = PointCloudScan().withOnly(cloud, std::vector<uint8_t>(50, 1));
    EXPECT_EQ(test::bytesOf(*same), test::bytesOf(cloud));
}

TYPED_TEST(PointCloudScanOf, keptAndRemovedTogetherAreTheOriginal) {
    const Cloud cloud = fullCloud<TypeParam>(200);
    const std::string before = test::bytesOf(cloud);
    for (uint32_t seed = 1; seed <= 5; ++seed) {
        const auto keep = test::randomMask(200, seed);
        const auto kept = PointCloudScan().withOnly(cloud, keep);
        const auto removed = PointCloudScan().withOnly(cloud, test::complementOf(keep));
        const auto& keptMap = *dynamic_cast<const Cloud&>(*kept).pointcloud;
        const auto& removedMap = *dynamic_cast<const Cloud&>(*removed).pointcloud;

        // The original again, its points taken from the two in turn.
        Cloud joined = fullCloud<TypeParam>(200);
        std::vector<float> fields;
        joined.pointcloud->getPointAllFields(0, fields);
        const std::vector<float> wiped(fields.size(), -1.0F);
        for (size_t i = 0; i < 200; ++i) joined.pointcloud->setPointAllFields(i, wiped);
        size_t k = 0, r = 0;
        for (size_t i = 0; i < 200; ++i) {
            if (keep[i]) {
                keptMap.getPointAllFields(k++, fields);
            } else {
                removedMap.getPointAllFields(r++, fields);
            }
            joined.pointcloud->setPointAllFieldsFast(i, fields);
        }
        EXPECT_EQ(k, keptMap.size());
        EXPECT_EQ(r, removedMap.size());
        EXPECT_EQ(test::bytesOf(joined), before);

        // All else of the observation: what is left when no point is.
        const std::vector<uint8_t> none(keptMap.size(), 0), noneOfAll(200, 0);
        EXPECT_EQ(test::bytesOf(*PointCloudScan().withOnly(*kept, none)),
                  test::bytesOf(*PointCloudScan().withOnly(cloud, noneOfAll)));
    }
    EXPECT_EQ(test::bytesOf(cloud), before) << "the original was changed";
}

}  // namespace
}  // namespace offmap::rawlog
