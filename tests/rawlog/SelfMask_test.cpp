// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"

#include <offmap/rawlog/CloudReducer.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/SelfMask.h>
#include <offmap/rawlog/TurnReducer.h>

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <vector>

namespace offmap::rawlog {
namespace {

using Cloud = mrpt::obs::CObservationPointCloud;
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

/// Walls 4 m around a robot, its mast 0.35 m before its sensor and its gripper, two metres ahead:
/// all of them vertical. Some points are there twice.
std::shared_ptr<Cloud> cloudOnRobot(const CPose3D& mounting) {
    auto cloud = std::make_shared<Cloud>();
    cloud->sensorLabel = "LIDAR";
    cloud->sensorPose = mounting;
    cloud->pointcloud = mrpt::maps::CSimplePointsMap::Create();
    const auto add = [&](double azimuth, double range, double z) {
        cloud->pointcloud->insertPoint(static_cast<float>(range * std::cos(azimuth)),
                                       static_cast<float>(range * std::sin(azimuth)),
                                       static_cast<float>(z));
    };
    for (int c = 0; c < 180; ++c) {
        const double azimuth = (c - 89.5) * std::numbers::pi / 90;
        const double wall = 4 / std::max(std::abs(std::cos(azimuth)), std::abs(std::sin(azimuth)));
        const double range = c < 8 ? 0.35 : (c > 86 && c < 93 ? 2.0 : wall);
        for (int r = 0; r <= 20; ++r) {
            const double z = range * (-0.2 + 0.02 * r);
            add(azimuth, range, z);
            if ((c + r) % 5 == 0) add(azimuth, range, z);
        }
    }
    return cloud;
}

core::LineMap roomMap() {
    const mrpt::math::TPoint2D a(-4, -4), b(4, -4), c(4, 4), d(-4, 4);
    return core::LineMap({{{a, b}}, {{b, c}}, {{c, d}}, {{d, a}}});
}

TurnScan organized(const Cloud& cloud, const SensorConfig& config) {
    const test::DrivenVehicle standing{CPose3D()};
    return scanClassOf(cloud, config)->organize({std::make_shared<Cloud>(cloud)}, standing, config);
}

/// What is said of the robot's own returns, word for word.
bool isOwn(const TPoint3D& pointInSensor, const CPose3D& sensorInVehicle,
           const SensorConfig& config) {
    if (pointInSensor.norm() < config.minRange) return true;
    if (!config.robotBox) return false;
    const TPoint3D p = sensorInVehicle.composePoint(pointInSensor);
    const auto& [min, max] = *config.robotBox;
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z &&
           p.z <= max.z;
}

SensorConfig someConfig(uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(0.2, 3);
    SensorConfig config;
    if (seed % 3 != 1) config.minRange = side(random);
    if (seed % 3 != 0) {
        config.robotBox = RobotBox{{-side(random), -side(random), -side(random)},
                                   {side(random), side(random), side(random)}};
    }
    return config;
}

}  // namespace

TEST(SelfMask, masksWhatABruteForceSearchFinds) {
    const CPose3D mounting(0.4, -0.1, 0.5, 2.1, 0.3, -0.2);
    const auto cloud = cloudOnRobot(mounting);
    for (uint32_t seed = 0; seed < 30; ++seed) {
        const SensorConfig config = someConfig(seed);
        TurnScan turn = organized(*cloud, config);
        const size_t columns = turn.scan.columns.size();
        maskSelfReturns(turn, config);

        std::set<uint32_t> left(turn.scan.sourceIndex.begin(), turn.scan.sourceIndex.end());
        for (const DuplicateReturn& duplicate : turn.duplicates) left.insert(duplicate.slot);
        size_t own = 0;
        for (uint32_t slot = 0; slot < cloud->pointcloud->size(); ++slot) {
            TPoint3D point;
            cloud->pointcloud->getPoint(slot, point.x, point.y, point.z);
            const bool masked = isOwn(point, mounting, config);
            own += masked;
            ASSERT_EQ(left.count(slot), masked ? 0U : 1U) << "seed " << seed << ", slot " << slot;
        }
        EXPECT_EQ(turn.counts.self, own);
        EXPECT_EQ(turn.counts.returns, cloud->pointcloud->size());
        EXPECT_EQ(turn.scan.columns.size(), columns);
    }
}

TEST(SelfMask, leavesAWellFormedScan) {
    const auto cloud = cloudOnRobot({});
    for (uint32_t seed = 0; seed < 30; ++seed) {
        const SensorConfig config = someConfig(seed);
        TurnScan turn = organized(*cloud, config);
        maskSelfReturns(turn, config);
        uint32_t end = 0;
        for (const core::ScanColumn& column : turn.scan.columns) {
            ASSERT_EQ(column.begin, end);
            ASSERT_LE(column.begin, column.end);
            end = column.end;
        }
        ASSERT_EQ(end, turn.scan.points.size());
        ASSERT_EQ(end, turn.scan.sourceIndex.size());
        const auto pointAt = [&](uint32_t slot) {
            TPoint3Df point;
            cloud->pointcloud->getPoint(slot, point.x, point.y, point.z);
            return point;
        };
        for (uint32_t i = 0; i < end; ++i) {
            ASSERT_EQ(turn.scan.points[i], pointAt(turn.scan.sourceIndex[i]));
        }
        for (const DuplicateReturn& duplicate : turn.duplicates) {
            ASSERT_EQ(turn.scan.points.at(duplicate.point), pointAt(duplicate.slot));
        }
    }
}

TEST(SelfMask, withoutSettingsTakesNothingOut) {
    const auto cloud = cloudOnRobot({});
    const TurnScan before = organized(*cloud, {});
    TurnScan turn = before;
    maskSelfReturns(turn, {});
    EXPECT_EQ(turn.scan.points, before.scan.points);
    EXPECT_EQ(turn.duplicates.size(), before.duplicates.size());
    EXPECT_EQ(turn.counts.self, 0U);
}

TEST(SelfMask, ownReturnsAreOnNoSegmentAndKept) {
    // A map with walls where the robot's own parts are: without the mask, they go.
    std::vector<core::Wall> walls = roomMap().walls();
    walls.push_back({{{2.0, -0.2}, {2.0, 0.2}}});
    const core::LineMap map(walls);
    const test::DrivenVehicle poses{CPose3D()};
    const auto cloud = cloudOnRobot({});
    Config config;
    config.reduction.vertical.minLength = 0.05;
    config.sensor.minRange = 0.5;
    config.sensor.robotBox = RobotBox{{1.5, -0.5, -1}, {2.5, 0.5, 1}};
    const auto reduced = [&](const Config& with) {
        TurnReducer reducer(map, poses, with, OutputClass::Same);
        return reducer.reduce({cloud}, *scanClassOf(*cloud, with.sensor));
    };
    Config without = config;
    without.sensor = {};
    const ReducedTurn masked = reduced(config), all = reduced(without);
    size_t own = 0, ownRemovedBefore = 0;
    for (uint32_t slot = 0; slot < cloud->pointcloud->size(); ++slot) {
        TPoint3D point;
        cloud->pointcloud->getPoint(slot, point.x, point.y, point.z);
        if (!isOwn(point, {}, config.sensor)) continue;
        ++own;
        ownRemovedBefore += all.removedSlots[slot];
        EXPECT_EQ(masked.removedSlots[slot], 0) << slot;
    }
    EXPECT_GT(ownRemovedBefore, 0U);
    EXPECT_EQ(masked.record.counts.self, own);
    EXPECT_LE(masked.record.onVerticalSegments + own, masked.record.counts.returns);
    EXPECT_GT(masked.record.removed(), cloud->pointcloud->size() / 2);
}

TEST(SelfMask, keptAndRemovedAreTheOriginal) {
    const core::LineMap map = roomMap();
    const test::DrivenVehicle poses{CPose3D()};
    const auto cloud = cloudOnRobot({});
    Config config;
    config.sensor.minRange = 2.5;
    TurnReducer reducer(map, poses, config, OutputClass::Same);
    const ScanClass& scanClass = *scanClassOf(*cloud, config.sensor);
    const ReducedTurn reduced = reducer.reduce({cloud}, scanClass);
    const auto removed = reducer.removedFrom({cloud}, reduced, scanClass);
    const auto sizeOf = [](const mrpt::obs::CObservation& obs) {
        return dynamic_cast<const Cloud&>(obs).pointcloud->size();
    };
    ASSERT_TRUE(reduced.reduced.front());
    EXPECT_GT(sizeOf(*removed.front()), 0U);
    EXPECT_GE(sizeOf(*reduced.reduced.front()), reduced.record.counts.self);
    EXPECT_EQ(sizeOf(*reduced.reduced.front()) + sizeOf(*removed.front()), sizeOf(*cloud));
}

TEST(SelfMask, holdsForCloudsOfAProgramsOwn) {
    const core::LineMap map = roomMap();
    Config config;
    config.sensor.minRange = 10;  // all of them
    CloudReducer reducer(map, config);
    const auto cloud = cloudOnRobot({});
    std::vector<TPoint3Df> points;
    for (size_t i = 0; i < cloud->pointcloud->size(); ++i) {
        TPoint3Df& point = points.emplace_back();
        cloud->pointcloud->getPoint(i, point.x, point.y, point.z);
    }
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.cov.setZero();
    const auto removedBy = [&](CloudReducer& by) {
        return std::ranges::count_if(by.reduce(points, pose), core::isRemoved);
    };
    EXPECT_EQ(removedBy(reducer), 0);
    EXPECT_EQ(reducer.organized().counts.self, points.size());
    CloudReducer unmasked(map);
    EXPECT_GT(removedBy(unmasked), 0);
}

}  // namespace offmap::rawlog
