// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ColumnRing.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <numbers>

namespace offmap::core {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Columns at azimuths that start somewhere and go on by a step.
OrganizedScan scanOf(int columns, double first, double step) {
    OrganizedScan scan;
    scan.columns.resize(static_cast<size_t>(columns));
    for (int c = 0; c < columns; ++c) {
        scan.columns[static_cast<size_t>(c)].azimuth =
            static_cast<float>(mrpt::math::wrapToPi((first + c * step) * degree));
    }
    return scan;
}

}  // namespace

TEST(ColumnRing, closedTurnGoesRoundItsEnd) {
    for (const double step : {1.0, -1.0}) {
        for (const double first : {-180.0, 0.0, 137.0}) {
            const OrganizedScan scan = scanOf(360, first, step);
            const ColumnRing ring(scan);
            for (uint32_t c = 0; c < 360; ++c) {
                EXPECT_EQ(ring.neighbour(c, +1), (c + 1) % 360);
                EXPECT_EQ(ring.neighbour(c, -1), (c + 359) % 360);
            }
        }
    }
}

TEST(ColumnRing, openSectorEndsAtItsEnds) {
    for (const double step : {1.0, -1.0}) {
        const OrganizedScan scan = scanOf(270, -135, step);
        const ColumnRing ring(scan);
        EXPECT_EQ(ring.neighbour(0, +1), 1u);
        EXPECT_FALSE(ring.neighbour(0, -1));
        EXPECT_EQ(ring.neighbour(269, -1), 268u);
        EXPECT_FALSE(ring.neighbour(269, +1));
    }
}

TEST(ColumnRing, fewDroppedColumnsAreCrossedAndAWideHoleIsNot) {
    OrganizedScan scan = scanOf(360, -180, 1);
    scan.columns.erase(scan.columns.begin() + 100, scan.columns.begin() + 101);
    scan.columns.erase(scan.columns.begin() + 200, scan.columns.begin() + 210);
    const ColumnRing ring(scan);
    EXPECT_EQ(ring.neighbour(99, +1), 100u);
    EXPECT_FALSE(ring.neighbour(199, +1));
    EXPECT_FALSE(ring.neighbour(200, -1));
}

TEST(ColumnRing, overlappingTurnIsNotClosed) {
    // 5 % more than a turn: the last columns look where the first did.
    const OrganizedScan scan = scanOf(378, -180, 1);
    EXPECT_FALSE(ColumnRing(scan).neighbour(377, +1));
}

TEST(ColumnRing, fewColumnsHaveFewNeighbours) {
    const OrganizedScan none, one = scanOf(1, 0, 1), two = scanOf(2, 0, 1);
    EXPECT_FALSE(ColumnRing(one).neighbour(0, +1));
    EXPECT_FALSE(ColumnRing(one).neighbour(0, -1));
    EXPECT_EQ(ColumnRing(two).neighbour(0, +1), 1u);
    EXPECT_EQ(ColumnRing(two).neighbour(1, -1), 0u);
    EXPECT_NO_THROW(ColumnRing{none});
}

TEST(ColumnRing, countsStepsInTheOrderOfRotation) {
    const OrganizedScan scan = scanOf(360, -180, 1);
    const ColumnRing ring(scan);
    EXPECT_EQ(ring.stepsBetween(10, 14), 4u);
    EXPECT_EQ(ring.stepsBetween(358, 3), 5u);
    EXPECT_EQ(ring.stepsBetween(7, 7), 0u);
}

}  // namespace offmap::core
