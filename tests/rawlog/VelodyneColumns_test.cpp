// SPDX-License-Identifier: BSD-3-Clause
#include "../support/SimulatedRobot.h"

#include <offmap/rawlog/VelodyneColumns.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace offmap::rawlog {
namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

/// [rad] from a column to a return in it.
double offColumn(const VelodyneReturns& decoded, uint32_t point, const VelodyneColumn& column) {
    const auto& p = decoded.points[point];
    return mrpt::math::wrapToPi(std::atan2(p.y, p.x) - column.azimuth);
}

/// Every return in one column, each laser once in a column.
void expectAllGathered(const VelodyneReturns& decoded, const VelodyneColumns& gathered) {
    std::vector<uint32_t> returns = gathered.returns;
    std::sort(returns.begin(), returns.end());
    std::vector<uint32_t> all(decoded.points.size());
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(returns, all);
    uint32_t next = 0;
    for (const VelodyneColumn& column : gathered.columns) {
        EXPECT_EQ(column.begin, next);
        next = column.end;
        std::set<int> lasers;
        for (uint32_t i = column.begin; i < column.end; ++i) {
            EXPECT_TRUE(lasers.insert(decoded.lasers[gathered.returns[i]]).second);
        }
    }
    EXPECT_EQ(next, all.size());
}

TEST(VelodyneColumns, withoutCorrectionsAreTheFirings) {
    test::SimulatedRobot robot;
    const VelodyneReturns decoded = decodePackets(*robot.hdl32(20));
    const VelodyneColumns gathered = gatherColumns(decoded);
    expectAllGathered(decoded, gathered);
    ASSERT_EQ(gathered.columns.size(), decoded.firings.size());
    for (size_t c = 0; c < gathered.columns.size(); ++c) {
        EXPECT_EQ(gathered.columns[c].begin, decoded.firings[c].begin);
        EXPECT_EQ(gathered.columns[c].end, decoded.firings[c].end);
        EXPECT_EQ(gathered.columns[c].azimuth, decoded.firings[c].azimuth);
        EXPECT_EQ(gathered.columns[c].time, decoded.firings[c].time);
    }
}

// A firing turns the head by 0.17 degrees. A whole number of firings meets a correction to within
// half of that; rotations are told in whole hundredths of degrees, which are off by half of one,
// and so may the mean of their steps be over the 26 firings that 4.5 degrees span.
TEST(VelodyneColumns, ofCorrectedLasersAreUpright) {
    test::SimulatedRobot robot;
    const VelodyneReturns decoded = decodePackets(*robot.hdl64(100));
    const VelodyneColumns gathered = gatherColumns(decoded);
    expectAllGathered(decoded, gathered);
    const double tolerance = mrpt::DEG2RAD(0.5 * 360 / (348 * 6) + 2 * 0.005 + 1e-3);
    size_t whole = 0;
    for (const VelodyneColumn& column : gathered.columns) {
        for (uint32_t i = column.begin; i < column.end; ++i) {
            EXPECT_LE(std::abs(offColumn(decoded, gathered.returns[i], column)), tolerance);
        }
        whole += column.end - column.begin == 64;
    }
    // Of 600 firings all but those at the ends, where lasers 9 degrees apart do not yet or no
    // longer all look.
    EXPECT_GE(whole, 600U - 60);
    EXPECT_GT(gathered.columns.size(), 600U + 40);
    for (size_t c = 1; c < gathered.columns.size(); ++c) {
        EXPECT_GE(gathered.columns[c].time, gathered.columns[c - 1].time);
    }
}

TEST(VelodyneColumns, ofCorrectedLasersStayUprightWherePacketsAreMissing) {
    test::SimulatedRobot robot;
    Scan scan = *robot.hdl64(60);
    scan.scan_packets.erase(scan.scan_packets.begin() + 20, scan.scan_packets.begin() + 25);
    const VelodyneReturns decoded = decodePackets(scan);
    const VelodyneColumns gathered = gatherColumns(decoded);
    expectAllGathered(decoded, gathered);
    const double tolerance = mrpt::DEG2RAD(0.5 * 360 / (348 * 6) + 2 * 0.005 + 1e-3);  // as above
    for (const VelodyneColumn& column : gathered.columns) {
        for (uint32_t i = column.begin; i < column.end; ++i) {
            EXPECT_LE(std::abs(offColumn(decoded, gathered.returns[i], column)), tolerance);
        }
    }
}

TEST(VelodyneColumns, ofAHeadThatStandsAreItsFirings) {
    Scan scan;
    scan.calibration = test::hdl64Calibration();
    scan.scan_packets = {test::emptyHdl64Packet(0), test::emptyHdl64Packet(288)};
    for (size_t laser = 0; laser < 32; ++laser) {
        test::setReturn(scan.scan_packets[1], 3, laser, 1000, 1);
    }
    const VelodyneReturns decoded = decodePackets(scan);
    const VelodyneColumns gathered = gatherColumns(decoded);
    expectAllGathered(decoded, gathered);
    ASSERT_EQ(gathered.columns.size(), 12U);
    EXPECT_EQ(gathered.columns[7].end - gathered.columns[7].begin, 32U);
}

TEST(VelodyneColumns, ofNoFiringsAreNone) { EXPECT_TRUE(gatherColumns({}).columns.empty()); }

}  // namespace
}  // namespace offmap::rawlog
