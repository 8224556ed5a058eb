// SPDX-License-Identifier: BSD-3-Clause
#include "SmallScan.h"

#include <offmap/view/CorrectedScan.h>

#include <gtest/gtest.h>

namespace offmap::view {
namespace {

/// Half a metre along x: (10, 20) was in truth (10.5, 20).
core::Alignment halfAMetre() {
    core::Alignment alignment;
    alignment.correction.pivot = {10, 20};
    alignment.correction.mean[0] = 0.5;
    return alignment;
}

TEST(CorrectedScan, columnsStandWhereTheScanShowsThem) {
    SmallScan small;
    small.result.alignment = halfAMetre();
    const core::OrganizedScan corrected = correctedScan(small.scan, small.result);
    ASSERT_EQ(corrected.columns.size(), 3U);
    for (const core::ScanColumn& column : corrected.columns) {
        EXPECT_DOUBLE_EQ(column.sensor->sensorInMap.x(), 10.5);
        EXPECT_DOUBLE_EQ(column.sensor->sensorInMap.y(), 20);
        EXPECT_DOUBLE_EQ(column.sensor->sensorInMap.z(), 1);
    }
    EXPECT_EQ(corrected.points, small.scan.points);
}

TEST(CorrectedScan, columnsWithoutPoseStayWithoutOne) {
    SmallScan small;
    small.result.alignment = halfAMetre();
    small.scan.columns[1].sensor.reset();
    EXPECT_FALSE(correctedScan(small.scan, small.result).columns[1].sensor);
}

TEST(CorrectedScan, aCorrectionThatDoesNotFitMovesNothing) {
    SmallScan small;
    small.result.alignment = halfAMetre();
    small.result.notReduced = core::PoseFault::DoesNotFit;
    EXPECT_DOUBLE_EQ(correctedScan(small.scan, small.result).columns[0].sensor->sensorInMap.x(),
                     10);
    small.result.alignment.reset();
    small.result.notReduced.reset();
    EXPECT_DOUBLE_EQ(correctedScan(small.scan, small.result).columns[0].sensor->sensorInMap.x(),
                     10);
}

}  // namespace
}  // namespace offmap::view
