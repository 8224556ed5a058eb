// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "TurnsInPieces.h"

#include <offmap/rawlog/ColumnStream.h>
#include <offmap/rawlog/PointCloudScan.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gtest/gtest.h>

#include <tuple>

namespace offmap::rawlog {
namespace {

using namespace std::chrono_literals;
using mrpt::Clock;

auto fieldsOf(const core::ScanColumn& c) {
    const auto& mount = c.sensorInVehicle;
    const auto pose = c.sensor ? c.sensor->sensorInMap.asTPose() : mrpt::math::TPose3D();
    return std::tuple(c.begin, c.end, c.azimuth, c.time, mount.x, mount.y, mount.z, mount.yaw,
                      c.sensor.has_value(), c.fault, pose.x, pose.y, pose.z, pose.yaw);
}

void expectSame(const TurnScan& a, const TurnScan& b) {
    EXPECT_EQ(a.scan.points, b.scan.points);
    EXPECT_EQ(a.scan.sourceIndex, b.scan.sourceIndex);
    ASSERT_EQ(a.scan.columns.size(), b.scan.columns.size());
    for (size_t c = 0; c < a.scan.columns.size(); ++c) {
        ASSERT_EQ(fieldsOf(a.scan.columns[c]), fieldsOf(b.scan.columns[c])) << c;
    }
    ASSERT_EQ(a.duplicates.size(), b.duplicates.size());
    for (size_t d = 0; d < a.duplicates.size(); ++d) {
        EXPECT_EQ(a.duplicates[d].slot, b.duplicates[d].slot);
        EXPECT_EQ(a.duplicates[d].point, b.duplicates[d].point);
    }
    EXPECT_EQ(a.counts.returns, b.counts.returns);
    EXPECT_EQ(a.counts.nonFinite, b.counts.nonFinite);
    EXPECT_EQ(a.counts.zero, b.counts.zero);
    EXPECT_EQ(a.counts.duplicates, b.counts.duplicates);
}

/// A vehicle whose poses come while it drives, and are never looked up before they are settled.
class PosesThatCome : public test::DrivenVehicle {
 public:
    PosesThatCome() : DrivenVehicle(test::turningPose) {}

    PoseLookup at(Clock::time_point time) const override {
        EXPECT_LT(time, until);
        return DrivenVehicle::at(time);
    }
    SettledPoses settled() const override { return {until, 0}; }

    Clock::time_point until = Clock::time_point::max();
};

TEST(ColumnStream, ofPiecesIsThatOfTheWholeTurn) {
    const test::DrivenVehicle poses(test::turningPose);
    const VelodyneScan scanClass;
    for (const auto& whole : test::velodyneTurns()) {
        const TurnScan expected = scanClass.organize({whole}, poses, {});
        ASSERT_GT(expected.scan.columns.size(), 300U);
        for (uint32_t seed = 1; seed <= 5; ++seed) {
            SCOPED_TRACE(testing::Message() << whole->sensorLabel << ", seed " << seed);
            const SensorConfig config;
            const auto stream = scanClass.columnStream(poses, config);
            TurnScan streamed;
            for (const size_t packets : test::randomPieces(whole->scan_packets.size(), seed)) {
                stream->add(test::firstPackets(*whole, packets), streamed);
            }
            stream->finish({whole}, streamed);
            expectSame(streamed, expected);
        }
    }
}

/// Columns that are there before the end, when so many packets have come.
size_t columnsOf(const test::VelodyneObservation& whole, size_t packets, const PoseSource& poses,
                 const SensorConfig& config = {}) {
    const auto stream = VelodyneScan().columnStream(poses, config);
    TurnScan streamed;
    stream->add(test::firstPackets(whole, packets), streamed);
    return streamed.scan.columns.size();
}

TEST(ColumnStream, firingsAreColumnsAsSoonAsTheyHaveCome) {
    test::SimulatedRobot robot;
    const test::DrivenVehicle poses(test::turningPose);
    EXPECT_EQ(columnsOf(*robot.vlp16(), 10, poses), 10U * 24);
    EXPECT_EQ(columnsOf(*robot.vlp16Dual(), 10, poses), 10U * 12) << "second returns come later";
    EXPECT_EQ(columnsOf(*robot.hdl32(), 10, poses), 10U * 12);
}

TEST(ColumnStream, whatOnlyTheWholeTurnTellsWaitsForItsEnd) {
    test::SimulatedRobot robot;
    const test::DrivenVehicle poses(test::turningPose);
    EXPECT_EQ(columnsOf(*robot.hdl64(20), 10, poses), 0U) << "lasers look to the side";
    SensorConfig config;
    config.timeReference = TimeReference::Last;
    const auto whole = robot.vlp16();
    EXPECT_EQ(columnsOf(*whole, 10, poses, config), 0U);
    const auto stream = VelodyneScan().columnStream(poses, config);
    TurnScan streamed;
    stream->add(test::firstPackets(*whole, 10), streamed);
    stream->finish({whole}, streamed);
    expectSame(streamed, VelodyneScan().organize({whole}, poses, config));
}

TEST(ColumnStream, ofAnotherClassGivesAllAtTheEnd) {
    test::SimulatedRobot robot;
    const test::DrivenVehicle poses(test::turningPose);
    const Turn turn{robot.cloud()};
    const SensorConfig config;
    const auto stream = PointCloudScan().columnStream(poses, config);
    TurnScan streamed;
    stream->add(turn, streamed);
    EXPECT_TRUE(streamed.scan.columns.empty());
}

// A packet of a VLP-16 lasts 1.327 ms, a column 55.296 us.
TEST(ColumnStream, columnsWaitForTheirPoses) {
    test::SimulatedRobot robot;
    const auto whole = robot.vlp16();
    PosesThatCome poses;
    poses.until = whole->timestamp + 10ms;
    const SensorConfig config;
    const VelodyneScan scanClass;
    const auto stream = scanClass.columnStream(poses, config);
    TurnScan streamed;
    stream->add(test::firstPackets(*whole, 20), streamed);
    EXPECT_EQ(streamed.scan.columns.size(), 181U) << "10 ms are 180.8 columns";
    stream->add(test::firstPackets(*whole, 30), streamed);
    EXPECT_EQ(streamed.scan.columns.size(), 181U);
    poses.until += 10ms;
    stream->add(test::firstPackets(*whole, 30), streamed);
    EXPECT_EQ(streamed.scan.columns.size(), 362U) << "of 361.7, without a packet more";
    poses.until = Clock::time_point::max();
    stream->finish({whole}, streamed);
    expectSame(streamed, scanClass.organize({whole}, poses, config));
}

TEST(ColumnStream, withoutSettledPosesAllComesAtTheEnd) {
    test::SimulatedRobot robot;
    const auto whole = robot.vlp16();
    const test::LostVehicle poses;
    EXPECT_EQ(columnsOf(*whole, 30, poses), 0U);
}

TEST(ColumnStream, observationsOfOneTurnFollowEachOther) {
    test::SimulatedRobot robot;
    const test::DrivenVehicle poses(test::turningPose);
    const auto first = robot.vlp16(30);
    robot.wait(0.1);
    const auto second = robot.vlp16(20);
    const VelodyneScan scanClass;
    const TurnScan both = scanClass.organize({first, second}, poses, {});
    const TurnScan alone = scanClass.organize({second}, poses, {});
    ASSERT_EQ(both.scan.columns.size(), 50U * 24);
    ASSERT_EQ(alone.scan.columns.size(), 20U * 24);
    const size_t points = both.scan.points.size() - alone.scan.points.size();
    for (size_t i = 0; i < alone.scan.points.size(); ++i) {
        EXPECT_EQ(both.scan.points[points + i], alone.scan.points[i]);
        EXPECT_EQ(both.scan.sourceIndex[points + i], 30U * 384 + alone.scan.sourceIndex[i]);
    }
}

}  // namespace
}  // namespace offmap::rawlog
