// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SimulatedRobot.h"

#include <offmap/rawlog/TurnReducer.h>
#include <offmap/rawlog/VelodynePackets.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace offmap::rawlog {
namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

/// Pairs of blocks turn by 40 hundredths of a degree.
test::VelodynePacket dualPacket(uint32_t stamp = 0) {
    auto packet = test::emptyVlp16Packet(stamp);
    packet.laser_return_mode = 0x39;
    for (size_t b = 0; b < 12; ++b) test::setRotation(packet, b, 40 * static_cast<int>(b / 2));
    return packet;
}

Scan scanOf(std::vector<test::VelodynePacket> packets) {
    Scan scan;
    scan.timestamp = mrpt::Clock::fromDouble(1.7e9);
    scan.scan_packets = std::move(packets);
    return scan;
}

TurnScan organized(const Scan& scan) {
    const test::DrivenVehicle still{mrpt::poses::CPose3D()};
    return VelodyneScan().organize({std::make_shared<Scan>(scan)}, still, {});
}

TEST(VelodyneDual, equalPairIsOneReturn) {
    auto packet = dualPacket();
    test::setReturn(packet, 2, 5, 1000, 7);
    test::setReturn(packet, 3, 5, 1000, 7);
    const TurnScan turn = organized(scanOf({packet}));
    EXPECT_EQ(turn.scan.columns.size(), 12U);
    ASSERT_EQ(turn.scan.points.size(), 1U);
    EXPECT_EQ(turn.scan.sourceIndex[0], 2U * 32 + 5);
    ASSERT_EQ(turn.duplicates.size(), 1U);
    EXPECT_EQ(turn.duplicates[0].slot, 3U * 32 + 5);
    EXPECT_EQ(turn.duplicates[0].point, 0U);
    EXPECT_EQ(turn.counts.returns, 2U);
    EXPECT_EQ(turn.counts.duplicates, 1U);
    EXPECT_EQ(turn.counts.zero, 384U - 2);
}

TEST(VelodyneDual, differentReturnsStandInColumnsBehindTheFirst) {
    auto packet = dualPacket();
    test::setReturn(packet, 2, 16 + 5, 1000, 7);
    test::setReturn(packet, 3, 16 + 5, 800, 7);
    test::setReturn(packet, 2, 16 + 6, 1000, 7);
    test::setReturn(packet, 3, 16 + 6, 1000, 7);
    const auto turn = organized(scanOf({packet}));
    ASSERT_EQ(turn.scan.columns.size(), 13U);  // of 12 firings one has other second returns
    const auto &first = turn.scan.columns[3], &second = turn.scan.columns[12];
    EXPECT_EQ(first.end - first.begin, 2U);
    ASSERT_EQ(second.end - second.begin, 1U);
    EXPECT_EQ(turn.scan.sourceIndex[second.begin], 3U * 32 + 16 + 5);
    EXPECT_EQ(second.azimuth, first.azimuth);
    EXPECT_EQ(second.time, first.time);
    EXPECT_TRUE(second.sensor);
}

TEST(VelodyneDual, onlyReturnOfALaserStandsInTheFirstColumn) {
    auto packet = dualPacket();
    test::setReturn(packet, 2, 5, 1000, 7);
    test::setReturn(packet, 3, 6, 1000, 7);
    const auto turn = organized(scanOf({packet}));
    ASSERT_EQ(turn.scan.columns.size(), 12U);
    EXPECT_EQ(turn.scan.columns[2].end - turn.scan.columns[2].begin, 2U);
}

// A pair is one block period, and turns by as much: laser 12 of the second firing fires
// 55.296 + 12 * 2.304 = 82.944 us later, which is 3/4 of 0.4 degrees.
TEST(VelodyneDual, timeAndAzimuthCountPairs) {
    auto packet = dualPacket();
    test::setReturn(packet, 10, 16 + 12, 1000, 1);
    const Scan scan = scanOf({packet});
    const VelodyneReturns decoded = decodePackets(scan);
    ASSERT_EQ(decoded.points.size(), 1U);
    const auto& p = decoded.points[0];
    EXPECT_NEAR(-mrpt::RAD2DEG(std::atan2(p.y, p.x)), 5 * 0.4 + 0.3, mrpt::RAD2DEG(4e-7));
    const std::chrono::duration<double, std::micro> late =
        decoded.firings.back().time - scan.timestamp;
    EXPECT_NEAR(late.count(), 5 * 110.592 + 55.296, 0.1);  // tick of mrpt::Clock
}

TEST(VelodyneDual, blocksOfUnequalRotationAreNoPair) {
    auto packet = dualPacket();
    test::setRotation(packet, 3, 41);
    test::setReturn(packet, 2, 5, 1000, 7);
    test::setReturn(packet, 3, 5, 1000, 7);
    const auto turn = organized(scanOf({packet}));
    EXPECT_EQ(turn.scan.columns.size(), 14U);
    EXPECT_EQ(turn.scan.points.size(), 2U);
}

TEST(VelodyneDual, equalPairGoesTogetherADifferentOnePartly) {
    test::SimulatedRobot robot;
    const auto scan = robot.vlp16Dual();
    const test::DrivenVehicle poses{robot.pose};
    const core::LineMap map(mapOf(evaluation::officeRoom()));
    TurnReducer reducer(map, poses, {}, OutputClass::Same);
    const VelodyneScan scanClass;
    const ReducedTurn reduced = reducer.reduce({scan}, scanClass);
    size_t both = 0, onlyLast = 0;
    for (size_t slot = 0; slot < scanClass.slotCount(*scan); ++slot) {
        if (slot / 32 % 2 == 1) continue;
        const bool equal =
            distanceOf(returnInSlot(*scan, slot)) == distanceOf(returnInSlot(*scan, slot + 32));
        const bool last = reduced.removedSlots[slot], strongest = reduced.removedSlots[slot + 32];
        EXPECT_TRUE(!equal || last == strongest) << "slot " << slot;
        both += equal && last;
        onlyLast += !equal && last && !strongest;
    }
    // Of 28,800 pairs every fifth differs; half of all returns are on walls.
    EXPECT_GT(both, 8000U);
    EXPECT_GT(onlyLast, 1500U);
    EXPECT_EQ(reduced.record.counts.duplicates, reduced.organized.duplicates.size());
}

TEST(VelodyneDual, pointCloudHoldsAnEqualPairOnce) {
    auto packet = dualPacket();
    test::setReturn(packet, 2, 5, 1000, 7);
    test::setReturn(packet, 3, 5, 1000, 7);
    test::setReturn(packet, 2, 6, 1000, 7);
    test::setReturn(packet, 3, 6, 900, 7);
    const Scan scan = scanOf({packet});
    const auto pointsOf = [&](const std::vector<uint8_t>& keep) {
        const auto obs = VelodyneScan().asPointCloud(scan, keep, {});
        return dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*obs).pointcloud->size();
    };
    std::vector<uint8_t> keep(384, 1);
    EXPECT_EQ(pointsOf(keep), 3U);
    keep[2 * 32 + 5] = 0;
    EXPECT_EQ(pointsOf(keep), 3U);
    keep[3 * 32 + 5] = 0;
    EXPECT_EQ(pointsOf(keep), 2U);
}

}  // namespace
}  // namespace offmap::rawlog
