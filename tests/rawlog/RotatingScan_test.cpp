// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "../support/RotatingMaker.h"
#include "../support/Scans.h"

#include <offmap/rawlog/RotatingScan.h>
#include <offmap/rawlog/VelodynePackets.h>

#include <gtest/gtest.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <chrono>
#include <cmath>
#include <map>

namespace offmap::rawlog {
namespace {

using mrpt::poses::CPose3D;
using Scan = mrpt::obs::CObservationRotatingScan;

const SensorConfig twoRows = test::withElevations({0.1, 0});

TurnScan organized(const Scan& scan, const SensorConfig& config,
                   const PoseSource& poses = test::DrivenVehicle(CPose3D())) {
    return RotatingScan().organize({std::make_shared<Scan>(scan)}, poses, config);
}

Scan withOnly(const Scan& scan, const std::vector<uint8_t>& keep) {
    return dynamic_cast<const Scan&>(*RotatingScan().withOnly(scan, keep));
}

/// With returns all over, a layer of last returns, and intensities.
Scan manyReturns() {
    uint16_t last = 0;
    const auto scan =
        test::rotatingScanOf([&](const auto&) { return ++last % 7 == 0 ? 0 : 0.01 * last; }, 24);
    test::addLastReturns(*scan);
    return *scan;
}

SensorConfig manyRows() {
    std::vector<double> elevations = test::rotatingElevations();
    for (double& elevation : elevations) elevation = mrpt::DEG2RAD(elevation);
    return test::withElevations(elevations);
}

TEST(RotatingScan, returnsStandBottomToTopInTheirColumn) {
    const auto scan = test::emptyRotatingScan(2, 8);
    scan->sensorPose = CPose3D(0, 0, 1, mrpt::DEG2RAD(90.0), 0, 0);
    scan->rangeImage(0, 2) = 1000;
    scan->rangeImage(1, 2) = 1500;
    scan->rangeImage(1, 7) = 500;
    const TurnScan turn = organized(*scan, twoRows);
    ASSERT_EQ(turn.scan.columns.size(), 2U) << "empty columns make none";
    const auto points = turn.scan.column(0);
    ASSERT_EQ(points.size(), 2U);
    const float tolerance = 4e-7F;  // two units in the last place of 3 m in float
    EXPECT_NEAR(points[0].y, 3, tolerance);
    EXPECT_NEAR(points[1].y, 2 * std::cos(0.1), tolerance);
    EXPECT_NEAR(points[1].z, 2 * std::sin(0.1), tolerance);
    EXPECT_EQ(turn.scan.sourceIndex, (std::vector<uint32_t>{10, 2, 15}));
    EXPECT_NEAR(std::abs(turn.scan.columns[0].azimuth), M_PI, tolerance) << "vehicle's axes";
    EXPECT_EQ(turn.counts.returns, 3U);
    EXPECT_EQ(turn.counts.zero, 13U);
}

TEST(RotatingScan, columnsArePlacedByTheirOwnTime) {
    const auto scan = test::emptyRotatingScan(2, 5);
    scan->rangeImage(0, 0) = scan->rangeImage(0, 3) = 1000;
    const test::DrivenVehicle drives([&](mrpt::Clock::time_point time) {
        return CPose3D(std::chrono::duration<double>(time - scan->timestamp).count(), 0, 0);
    });
    const TurnScan turn = organized(*scan, twoRows, drives);
    ASSERT_EQ(turn.scan.columns.size(), 2U);
    EXPECT_EQ(turn.scan.columns[0].sensor->sensorInMap.x(), 0);
    // 1 m/s for three quarters of 0.1 s, to a tick of 100 ns.
    EXPECT_NEAR(turn.scan.columns[1].sensor->sensorInMap.x(), 0.075, 1e-7);
}

TEST(RotatingScan, equalRangesOfTwoLayersAreOneReturn) {
    const auto scan = test::emptyRotatingScan(2, 8);
    auto& last = scan->rangeOtherLayers["LAST"];
    last.setZero(2, 8);
    scan->rangeImage(0, 2) = last(0, 2) = 1000;  // the same
    scan->rangeImage(1, 2) = 1500, last(1, 2) = 1600;
    last(1, 5) = 700;  // alone
    const TurnScan turn = organized(*scan, twoRows);
    ASSERT_EQ(turn.scan.columns.size(), 3U);
    EXPECT_EQ(turn.scan.sourceIndex, (std::vector<uint32_t>{10, 2, 16 + 10, 16 + 13}));
    EXPECT_EQ(turn.scan.columns[1].azimuth, turn.scan.columns[0].azimuth) << "behind all others";
    ASSERT_EQ(turn.duplicates.size(), 1U);
    EXPECT_EQ(turn.duplicates[0].slot, 16U + 2);
    EXPECT_EQ(turn.duplicates[0].point, 1U);
    EXPECT_EQ(turn.counts.returns, 5U);
    EXPECT_EQ(turn.counts.duplicates, 1U);
    EXPECT_EQ(turn.counts.zero, 32U - 5);
}

TEST(RotatingScan, everyReturnIsInTheScanOrRepeatsOne) {
    const Scan scan = manyReturns();
    const TurnScan turn = organized(scan, manyRows());
    const size_t returns = test::returnsOf(scan).size();
    EXPECT_EQ(turn.counts.returns, returns);
    EXPECT_EQ(turn.counts.zero + returns, RotatingScan().slotCount(scan));
    EXPECT_EQ(turn.scan.points.size() + turn.duplicates.size(), returns);
    EXPECT_GT(turn.duplicates.size(), returns / 4) << "two thirds of the last returns";
    std::vector<uint8_t> seen(RotatingScan().slotCount(scan), 0);
    for (const uint32_t slot : turn.scan.sourceIndex) ++seen[slot];
    for (const DuplicateReturn& duplicate : turn.duplicates) ++seen[duplicate.slot];
    size_t slot = 0;
    for (const auto* image : {&scan.rangeImage, &scan.rangeOtherLayers.at("LAST")}) {
        for (int row = 0; row < image->rows(); ++row) {
            for (int column = 0; column < image->cols(); ++column) {
                EXPECT_EQ(seen[slot++], (*image)(row, column) != 0 ? 1 : 0);
            }
        }
    }
}

TEST(RotatingScan, keptAndRemovedAreTheOriginal) {
    const Scan scan = manyReturns();
    const auto all = test::returnsOf(scan);
    for (uint32_t seed = 1; seed <= 5; ++seed) {
        const auto keep = test::randomMask(RotatingScan().slotCount(scan), seed);
        const Scan kept = withOnly(scan, keep), removed = withOnly(scan, test::complementOf(keep));
        const auto left = test::returnsOf(kept);
        EXPECT_EQ(test::together(left, test::returnsOf(removed)), all);
        // Of 1,320 returns 60 % are kept, give or take four sigma of 0.018.
        EXPECT_NEAR(double(left.size()) / double(all.size()), 0.6, 0.072);
    }
    const std::vector<uint8_t> everything(RotatingScan().slotCount(scan), 1);
    EXPECT_EQ(test::bytesOf(withOnly(scan, everything)), test::bytesOf(scan));
}

TEST(RotatingScan, intensityImageOfAnotherSizeIsLeftAlone) {
    Scan scan = manyReturns();
    scan.intensityImage.fill(7);
    scan.intensityImage.conservativeResize(5, 5);
    const std::vector<uint8_t> nothing(RotatingScan().slotCount(scan), 0);
    const Scan empty = withOnly(scan, nothing);
    EXPECT_TRUE(test::returnsOf(*RotatingScan().asPointCloud(empty, nothing, manyRows())).empty());
    EXPECT_EQ(empty.intensityImage, scan.intensityImage);
}

TEST(RotatingScan, pointCloudHasThePointsOfTheColumns) {
    const Scan scan = manyReturns();
    const auto keep = test::randomMask(RotatingScan().slotCount(scan), 9);
    const auto obs = RotatingScan().asPointCloud(scan, keep, manyRows());
    const auto& cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*obs);
    const auto& map = dynamic_cast<const mrpt::maps::CPointsMapXYZI&>(*cloud.pointcloud);
    EXPECT_EQ(cloud.timestamp, scan.timestamp);

    const TurnScan turn = organized(scan, manyRows());
    std::map<uint32_t, mrpt::math::TPoint3Df> points;  // by slot
    for (size_t i = 0; i < turn.scan.points.size(); ++i) {
        points[turn.scan.sourceIndex[i]] = turn.scan.points[i];
    }
    for (const auto& copy : turn.duplicates) points[copy.slot] = turn.scan.points[copy.point];
    std::erase_if(points, [&](const auto& entry) { return !keep[entry.first]; });
    ASSERT_EQ(map.size(), points.size());
    size_t i = 0;
    for (const auto& [slot, point] : points) {
        float x = 0, y = 0, z = 0;
        map.getPoint(i, x, y, z);
        EXPECT_EQ(mrpt::math::TPoint3Df(x, y, z), point);
        const auto row = static_cast<int>(slot / 24);
        EXPECT_EQ(map.getPointIntensity_fast(i++),
                  row < 32 ? static_cast<float>(10 + row) / 255.0F : 0);
    }
}

TEST(RotatingScan, pointCloudWithoutIntensitiesIsSimple) {
    Scan scan = manyReturns();
    scan.intensityImage.setSize(0, 0);
    const std::vector<uint8_t> all(RotatingScan().slotCount(scan), 1);
    const auto obs = RotatingScan().asPointCloud(scan, all, manyRows());
    const auto& cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*obs);
    EXPECT_TRUE(dynamic_cast<const mrpt::maps::CSimplePointsMap*>(cloud.pointcloud.get()));
    EXPECT_EQ(cloud.pointcloud->size(), test::returnsOf(scan).size());
}

TEST(RotatingScan, maskOfAnotherSizeIsRefused) {
    const auto scan = test::emptyRotatingScan(2, 8);
    EXPECT_THROW(RotatingScan().withOnly(*scan, std::vector<uint8_t>(15, 1)),
                 std::invalid_argument);
    EXPECT_THROW(RotatingScan().asPointCloud(*scan, std::vector<uint8_t>(17, 1), twoRows),
                 std::invalid_argument);
}

/// The two real samples are of the same turn.
TEST(RotatingScan, pointsOfTheRealScanAreThoseOfItsPackets) {
    const auto scan =
        test::observationsIn<Scan>("/usr/share/mrpt/datasets/rot_scan_velodyne.rawlog").at(0);
    const auto packets = test::observationsIn<mrpt::obs::CObservationVelodyneScan>(
                             "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog")
                             .at(0);
    const VelodyneReturns decoded = decodePackets(*packets);
    std::map<uint32_t, mrpt::math::TPoint3Df> pointInSlot;
    for (size_t i = 0; i < decoded.points.size(); ++i) {
        pointInSlot[decoded.slots[i]] = decoded.points[i];
    }
    const TurnScan turn = organized(*scan, {});
    ASSERT_EQ(turn.scan.points.size(), 11'305U) << "what MRPT took over";
    double farthest = 0;  // [rad]
    for (size_t i = 0; i < turn.scan.points.size(); ++i) {
        const uint32_t row = turn.scan.sourceIndex[i] / scan->columnCount;
        const uint32_t column = turn.scan.sourceIndex[i] % scan->columnCount;
        ASSERT_EQ(column % 2, 0U);
        const auto original = pointInSlot.find(column / 2 * 32 + row);
        ASSERT_NE(original, pointInSlot.end());
        const auto& p = turn.scan.points[i];
        const double range = original->second.norm();
        EXPECT_NEAR(p.norm(), range, 1e-6 * range) << "both in float";
        farthest = std::max(farthest, (p - original->second).norm() / range);
    }
    // The packets' lasers fire one after the other, the last 34.56 us after the first, while the
    // head turns by 0.12 degrees; and it does not turn quite evenly.
    double uneven = 0;  // [deg]
    for (size_t block = 0; block < 900; ++block) {
        const auto& packet = packets->scan_packets[block / 12];
        double rotation = 0.01 * packet.blocks[block % 12].rotation();
        if (rotation < 3.43) rotation += 360;
        const double evenly = 3.43 + 357.85 * static_cast<double>(block) / 900;
        uneven = std::max(uneven, std::abs(rotation - evenly));
    }
    EXPECT_LT(uneven, 0.2) << "half a block; columns that were miscounted would be off by one";
    EXPECT_LT(farthest, mrpt::DEG2RAD(uneven + 34.56 / 110.592 * 357.85 / 900) + 1e-6);
}

}  // namespace
}  // namespace offmap::rawlog
