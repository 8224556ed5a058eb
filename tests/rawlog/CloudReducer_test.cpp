// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/CloudReducer.h>
#include <offmap/rawlog/FixedPose.h>
#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/TurnReducer.h>

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace offmap::rawlog {
namespace {

using core::PointLabel;
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;
using mrpt::poses::CPose3DPDFGaussian;

const CPose3D sensorInVehicle(0.2, 0, 1, 0, 0, 0);

CPose3DPDFGaussian atOrigin() {
    CPose3DPDFGaussian pose;
    pose.cov.setDiagonal(6, 1e-4);  // 1 cm, 0.6 degrees
    return pose;
}

/// A wall 2 m high in front of the vehicle, 3 m from its origin, and a post between them.
std::vector<TPoint3Df> wallAndPost() {
    std::vector<TPoint3Df> points;
    for (int step = -20; step <= 20; ++step) {
        const double tangent = std::tan(mrpt::DEG2RAD(1.0 * step));
        const double range = std::abs(step) < 3 ? 1.8 : 2.8;  // [m] from the sensor
        for (int row = 0; row <= 20; ++row) {
            points.emplace_back(static_cast<float>(range), static_cast<float>(range * tangent),
                                static_cast<float>(0.1 * row - 1.0));
        }
    }
    return points;
}

core::LineMap wallMap() { return core::LineMap({{{{3, -2}, {3, 2}}}}); }

std::ptrdiff_t removedOf(const std::vector<PointLabel>& labels) {
    return std::ranges::count_if(labels, core::isRemoved);
}

TEST(CloudReducer, removesTheWallAndKeepsThePost) {
    const core::LineMap map = wallMap();
    const std::vector<TPoint3Df> points = wallAndPost();
    const auto labels = CloudReducer(map).reduce(points, atOrigin(), sensorInVehicle);
    ASSERT_EQ(labels.size(), points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(core::isRemoved(labels[i]), points[i].x > 2) << i;
    }
}

TEST(CloudReducer, saysTheSameAsForAnObservation) {
    const core::LineMap map = wallMap();
    const std::vector<TPoint3Df> points = wallAndPost();
    auto observation = std::make_shared<mrpt::obs::CObservationPointCloud>();
    observation->sensorPose = sensorInVehicle;
    observation->pointcloud = mrpt::maps::CSimplePointsMap::Create();
    for (const auto& p : points) observation->pointcloud->insertPoint(p.x, p.y, p.z);

    const FixedPose pose(atOrigin());
    const ReducedTurn turn =
        TurnReducer(map, pose, {}, OutputClass::Same).reduce({observation}, PointCloudScan());
    const auto labels = CloudReducer(map).reduce(points, atOrigin(), sensorInVehicle);
    ASSERT_EQ(labels.size(), turn.removedSlots.size());
    for (size_t i = 0; i < labels.size(); ++i) {
        EXPECT_EQ(core::isRemoved(labels[i]), turn.removedSlots[i] != 0) << i;
    }
}

TEST(CloudReducer, whatIsNoReturnStaysAndMovesNoLabel) {
    const core::LineMap map = wallMap();
    const std::vector<TPoint3Df> points = wallAndPost();
    CloudReducer reducer(map);
    const auto without = reducer.reduce(points, atOrigin(), sensorInVehicle);
    std::vector<TPoint3Df> more = points;
    more.insert(more.begin(), TPoint3Df(std::numeric_limits<float>::quiet_NaN(), 0, 0));
    more.insert(more.begin() + 100, TPoint3Df(0, 0, 0));
    auto with = reducer.reduce(more, atOrigin(), sensorInVehicle);
    EXPECT_EQ(with.at(0), PointLabel::NotOnVerticalSegment);
    EXPECT_EQ(with.at(100), PointLabel::NotOnVerticalSegment);
    with.erase(with.begin() + 100);
    with.erase(with.begin());
    EXPECT_EQ(with, without);
    EXPECT_EQ(reducer.organized().counts.nonFinite, 1U);
    EXPECT_EQ(reducer.organized().counts.zero, 1U);
}

TEST(CloudReducer, repeatedPointsShareTheirLabel) {
    const core::LineMap map = wallMap();
    const std::vector<TPoint3Df> points = wallAndPost();
    std::vector<TPoint3Df> twice = points;
    twice.insert(twice.end(), points.begin(), points.end());
    const auto labels = CloudReducer(map).reduce(twice, atOrigin(), sensorInVehicle);
    EXPECT_GT(removedOf(labels), 0);
    EXPECT_TRUE(std::ranges::equal(std::span(labels).first(points.size()),
                                   std::span(labels).last(points.size())));
}

TEST(CloudReducer, withoutAUsablePoseEverythingStays) {
    const core::LineMap map = wallMap();
    CloudReducer reducer(map);
    CPose3DPDFGaussian pose = atOrigin();
    pose.cov(0, 0) = -1;
    EXPECT_EQ(removedOf(reducer.reduce(wallAndPost(), pose, sensorInVehicle)), 0);
    EXPECT_EQ(reducer.result().notReduced, core::PoseFault::NotPsd);
    pose.mean.x(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(removedOf(reducer.reduce(wallAndPost(), pose, sensorInVehicle)), 0);
    EXPECT_EQ(reducer.result().notReduced, core::PoseFault::NotFinite);
}

TEST(CloudReducer, emptyCloudGivesNoLabels) {
    const core::LineMap map = wallMap();
    EXPECT_TRUE(CloudReducer(map).reduce({}, atOrigin()).empty());
}

TEST(CloudReducer, refusesAConfigurationThatIsNone) {
    const core::LineMap map = wallMap();
    Config config;
    config.sensor.columnWidth = -1;
    EXPECT_THROW(CloudReducer(map, config), std::invalid_argument);
}

TEST(XyzOf, takesWhateverHasCoordinates) {
    struct PointXYZI {
        float x, y, z, unused, intensity;
    };
    const std::vector<PointXYZI> points{{1, 2, 3, 0, 9}, {4, 5, 6, 0, 9}};
    EXPECT_EQ(xyzOf(points), (std::vector<TPoint3Df>{{1, 2, 3}, {4, 5, 6}}));
}

}  // namespace
}  // namespace offmap::rawlog
