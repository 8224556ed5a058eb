// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/VelodyneMaker.h"

#include <offmap/rawlog/VelodynePackets.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gtest/gtest.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace offmap::rawlog {
namespace {

using mrpt::poses::CPose3D;
using Scan = mrpt::obs::CObservationVelodyneScan;

Scan realScan() {
    const char* const file = "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog";
    return *test::observationsIn<Scan>(file).at(0);
}

/// With a cloud as MRPT stores it, all vectors filled.
Scan realScanWithCloud() {
    Scan scan = realScan();
    Scan::TGeneratePointCloudParameters all;
    all.generatePerPointTimestamp = all.generatePerPointAzimuth = true;
    all.generatePointsForLaserID = true;
    scan.generatePointCloud(all);
    return scan;
}

Scan withOnly(const Scan& scan, const std::vector<uint8_t>& keep,
              Leftovers leftovers = Leftovers::Keep) {
    return dynamic_cast<const Scan&>(*VelodyneScan().withOnly(scan, keep, leftovers));
}

TurnScan organized(const Scan& scan, const PoseSource& poses) {
    return VelodyneScan().organize({std::make_shared<Scan>(scan)}, poses, {});
}

TEST(VelodyneScan, columnsOfTheRealScanStandBottomToTopInTheOrderOfRotation) {
    const TurnScan turn = organized(realScan(), test::DrivenVehicle(CPose3D()));
    const auto& columns = turn.scan.columns;
    ASSERT_EQ(columns.size(), 1800U);
    double turned = 0;
    for (size_t c = 0; c < columns.size(); ++c) {
        const auto points = turn.scan.column(c);
        for (size_t i = 1; i < points.size(); ++i) {
            const auto elevation = [](const auto& p) { return p.z / std::hypot(p.x, p.y); };
            EXPECT_LT(elevation(points[i - 1]), elevation(points[i]));
        }
        if (c == 0) continue;
        EXPECT_EQ(columns[c].begin, columns[c - 1].end);
        EXPECT_GT(columns[c].time, columns[c - 1].time);
        const double step = mrpt::math::wrapToPi(static_cast<double>(columns[c].azimuth) -
                                                 static_cast<double>(columns[c - 1].azimuth));
        EXPECT_LT(step, 0) << "clockwise, column " << c;
        turned += step;
    }
    // 900 blocks of about 0.4 degrees.
    EXPECT_NEAR(turned, -2 * std::numbers::pi, 0.05);
    EXPECT_EQ(columns.back().end, 22591U);
    EXPECT_EQ(turn.counts.returns, 22591U);
    EXPECT_EQ(turn.counts.zero, 75U * 384 - 22591);
    EXPECT_EQ(turn.counts.duplicates + turn.counts.nonFinite, 0U);
}

// A column's azimuth is that of the middle of its firing; its returns lie within half a firing,
// 7.5 lasers of 0.0083 degrees, and the mounting turns all of them.
TEST(VelodyneScan, azimuthOfAColumnIsThatOfItsReturnsInTheVehicle) {
    Scan scan = realScan();
    scan.sensorPose = CPose3D(1, 2, 3, 2.0, 0, 0);
    const TurnScan turn = organized(scan, test::DrivenVehicle(CPose3D()));
    for (size_t c = 0; c < turn.scan.columns.size(); ++c) {
        for (const auto& p : turn.scan.column(c)) {
            const double azimuth = std::atan2(p.y, p.x) + 2.0;
            const double off = mrpt::math::wrapToPi(azimuth - turn.scan.columns[c].azimuth);
            EXPECT_LE(std::abs(off), mrpt::DEG2RAD(7.5 * 0.01));
        }
    }
}

TEST(VelodyneScan, sensorOnItsHeadIsStillReadBottomToTop) {
    Scan scan = realScan();
    scan.sensorPose = CPose3D(0, 0, 2, 0, 0, std::numbers::pi);
    const TurnScan turn = organized(scan, test::DrivenVehicle(CPose3D()));
    for (size_t c = 0; c < turn.scan.columns.size(); ++c) {
        const auto points = turn.scan.column(c);
        for (size_t i = 1; i < points.size(); ++i) {
            const auto elevation = [](const auto& p) { return -p.z / std::hypot(p.x, p.y); };
            EXPECT_LT(elevation(points[i - 1]), elevation(points[i]));
        }
    }
}

TEST(VelodyneScan, eachColumnHasThePoseOfItsTime) {
    Scan scan = realScan();
    scan.sensorPose = CPose3D(0.5, 0, 1.2, 0, 0, 0);
    const auto start = scan.timestamp;
    const test::DrivenVehicle forward([&](mrpt::Clock::time_point t) {
        return CPose3D(10.0 * mrpt::system::timeDifference(start, t), 0, 0, 0, 0, 0);
    });
    const TurnScan turn = organized(scan, forward);
    const auto& last = turn.scan.columns.back();
    ASSERT_TRUE(last.sensor);
    // 74 packets of 1.327 ms, then 23 firings of 55.296 us, at 10 m/s; stamps count whole us.
    EXPECT_NEAR(last.sensor->sensorInMap.x(), 0.5 + 10 * (74 * 1.32709e-3 + 23 * 55.296e-6), 1e-4);
    EXPECT_DOUBLE_EQ(last.sensor->sensorInMap.z(), 1.2);
}

TEST(VelodyneScan, columnsWithoutAPoseSayWhy) {
    const TurnScan turn = organized(realScan(), test::LostVehicle());
    for (const auto& column : turn.scan.columns) {
        EXPECT_FALSE(column.sensor);
        EXPECT_EQ(column.fault, core::PoseFault::TooOld);
    }
}

TEST(VelodyneScan, keptAndRemovedTogetherAreTheOriginal) {
    const Scan scan = realScan();
    for (uint32_t seed = 1; seed <= 5; ++seed) {
        const auto keep = test::randomMask(VelodyneScan().slotCount(scan), seed);
        Scan kept = withOnly(scan, keep);
        const Scan removed = withOnly(scan, test::complementOf(keep), Leftovers::Drop);
        for (size_t slot = 0; slot < keep.size(); ++slot) {
            const auto& gone = returnInSlot(keep[slot] ? removed : kept, slot);
            EXPECT_EQ(distanceOf(gone), 0);
            EXPECT_EQ(gone.intensity(), 0);
            if (keep[slot]) continue;
            kept.scan_packets[slot / 384].blocks[slot / 32 % 12].laser_returns[slot % 32] =
                returnInSlot(removed, slot);
        }
        EXPECT_EQ(test::bytesOf(kept), test::bytesOf(scan));
    }
}

TEST(VelodyneScan, storedCloudFollowsItsReturns) {
    const Scan scan = realScanWithCloud();
    const auto keep = test::randomMask(VelodyneScan().slotCount(scan), 7);
    const Scan kept = withOnly(scan, keep);
    const Scan removed = withOnly(scan, test::complementOf(keep), Leftovers::Drop);
    EXPECT_EQ(kept.point_cloud.size() + removed.point_cloud.size(), scan.point_cloud.size());

    // What MRPT makes of the reduced packets is what the reduced cloud must hold.
    Scan again = kept;
    Scan::TGeneratePointCloudParameters all;
    all.generatePerPointTimestamp = all.generatePerPointAzimuth = true;
    all.generatePointsForLaserID = true;
    again.generatePointCloud(all);
    EXPECT_EQ(test::bytesOf(again), test::bytesOf(kept));
}

TEST(VelodyneScan, pointOfNoReturnStaysWithTheKept) {
    Scan scan = realScanWithCloud();
    auto& cloud = scan.point_cloud;
    cloud.x.back() = 500;
    const std::vector<uint8_t> none(VelodyneScan().slotCount(scan), 0);
    const Scan kept = withOnly(scan, none, Leftovers::Keep);
    ASSERT_EQ(kept.point_cloud.size(), 1U);
    EXPECT_EQ(kept.point_cloud.x[0], 500);
    EXPECT_EQ(kept.point_cloud.laser_id[0], cloud.laser_id.back());
    EXPECT_EQ(withOnly(scan, none, Leftovers::Drop).point_cloud.size(), 0U);
}

TEST(VelodyneScan, damagedPointsOfTheCloudStayWithTheKept) {
    Scan scan = realScanWithCloud();
    auto& cloud = scan.point_cloud;
    cloud.x[0] = std::numeric_limits<float>::max();  // its square is infinite
    cloud.y[1] = std::numeric_limits<float>::quiet_NaN();
    cloud.z[2] = -std::numeric_limits<float>::infinity();
    const std::vector<uint8_t> none(VelodyneScan().slotCount(scan), 0);
    EXPECT_EQ(withOnly(scan, none, Leftovers::Keep).point_cloud.size(), 3U);
    EXPECT_EQ(withOnly(scan, none, Leftovers::Drop).point_cloud.size(), 0U);
    cloud.z.pop_back();
    EXPECT_EQ(withOnly(scan, none, Leftovers::Keep).point_cloud.size(), cloud.x.size());
    EXPECT_EQ(withOnly(scan, none, Leftovers::Drop).point_cloud.size(), 0U);
}

TEST(VelodyneScan, vectorsOfTheCloudThatWereNotFilledStayEmpty) {
    Scan scan = realScan();
    scan.generatePointCloud();
    const Scan kept = withOnly(scan, test::randomMask(VelodyneScan().slotCount(scan), 9));
    EXPECT_GT(kept.point_cloud.size(), 0U);
    EXPECT_LT(kept.point_cloud.size(), scan.point_cloud.size());
    EXPECT_TRUE(kept.point_cloud.timestamp.empty());
    EXPECT_TRUE(kept.point_cloud.azimuth.empty());
    for (const auto& points : kept.point_cloud.pointsForLaserID) EXPECT_TRUE(points.empty());
}

TEST(VelodyneScan, pointCloudHoldsTheChosenReturnsWithIntensity) {
    auto packet = test::emptyVlp16Packet(0);
    test::setReturn(packet, 0, 1, 1000, 51);
    test::setReturn(packet, 0, 3, 2000, 102);
    Scan scan;
    scan.sensorLabel = "VELODYNE";
    scan.timestamp = mrpt::Clock::fromDouble(1.7e9);
    scan.sensorPose = CPose3D(1, 2, 3, 0.1, 0.2, 0.3);
    scan.scan_packets = {packet};
    std::vector<uint8_t> keep(384, 1);
    keep[1] = 0;
    const auto obs = VelodyneScan().asPointCloud(scan, keep, {});
    const auto& out = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*obs);
    EXPECT_EQ(out.sensorLabel, "VELODYNE");
    EXPECT_EQ(out.timestamp, scan.timestamp);
    EXPECT_EQ(out.sensorPose, scan.sensorPose);
    const auto& map = dynamic_cast<const mrpt::maps::CPointsMapXYZI&>(*out.pointcloud);
    ASSERT_EQ(map.size(), 1U);
    EXPECT_FLOAT_EQ(map.getPointIntensity_fast(0), 0.4F);
    EXPECT_NEAR(map.getPointsBufferRef_z()[0], 4 * std::sin(mrpt::DEG2RAD(3.0)), 4 * 2e-7);
}

TEST(VelodyneScan, maskOfTheWrongSizeIsRefused) {
    EXPECT_THROW(withOnly(realScan(), {1, 0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace offmap::rawlog
