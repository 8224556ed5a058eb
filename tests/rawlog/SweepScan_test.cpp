// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SharedData.h"
#include "../support/SweepMaker.h"

#include <offmap/rawlog/SweepScan.h>

#include <gtest/gtest.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <limits>

namespace offmap::rawlog {
namespace {

using test::Fan;
using test::fanIn;
using test::fanPose;
using test::wallAhead;

Fan withOnly(const Fan& fan, const std::vector<uint8_t>& keep, Leftovers leftovers) {
    return dynamic_cast<const Fan&>(*SweepScan().withOnly(fan, keep, leftovers));
}

/// Puts the valid rays of one fan back into another.
void putBack(Fan& into, const Fan& from) {
    for (size_t i = 0; i < from.getScanSize(); ++i) {
        if (!from.getScanRangeValidity(i)) continue;
        into.setScanRangeValidity(i, true);
        into.setScanRange(i, from.getScanRange(i));
        if (from.hasIntensity()) into.setScanIntensity(i, from.getScanIntensity(i));
    }
}

void expectKeptAndRemovedAreAll(const Fan& fan) {
    for (uint32_t seed = 1; seed <= 5; ++seed) {
        const auto keep = test::randomMask(fan.getScanSize(), seed);
        Fan kept = withOnly(fan, keep, Leftovers::Keep);
        const Fan removed = withOnly(fan, test::complementOf(keep), Leftovers::Drop);
        for (size_t i = 0; i < keep.size(); ++i) {
            EXPECT_EQ(kept.getScanRangeValidity(i), fan.getScanRangeValidity(i) && keep[i]);
            EXPECT_EQ(removed.getScanRangeValidity(i), fan.getScanRangeValidity(i) && !keep[i]);
        }
        putBack(kept, removed);
        EXPECT_EQ(test::bytesOf(kept), test::bytesOf(fan));
    }
}

TEST(SweepScan, keptAndRemovedTogetherAreTheOriginal) {
    OFFMAP_NEEDS_SHARED_DATA()
    const auto fans = test::observationsIn<Fan>(test::sharedData("room/room1.rawlog"));
    for (size_t c = 0; c < fans.size(); c += 100) expectKeptAndRemovedAreAll(*fans[c]);
}

TEST(SweepScan, intensitiesFollowTheirRays) {
    auto fan = fanIn(wallAhead(3), fanPose(0));
    fan->setScanHasIntensity(true);
    for (size_t i = 0; i < fan->getScanSize(); ++i) fan->setScanIntensity(i, static_cast<int>(i));
    // What an invalid ray holds is none of our business.
    fan->setScanRangeValidity(20, false);
    fan->setScanRange(20, 77.0F);
    expectKeptAndRemovedAreAll(*fan);
    const Fan none = withOnly(*fan, std::vector<uint8_t>(fan->getScanSize(), 0), Leftovers::Drop);
    EXPECT_EQ(none.getScanRange(20), 77.0F);
    EXPECT_EQ(none.getScanIntensity(20), 20);
    EXPECT_EQ(none.getScanRange(21), 0.0F);
    EXPECT_EQ(none.getScanIntensity(21), 0);
}

TEST(SweepScan, pointCloudIsInTheFrameOfTheScan) {
    const auto fan = fanIn(wallAhead(2), fanPose(30), {.aperture = 90, .rays = 3});
    fan->setScanRange(0, 1.5F);
    fan->setScanRangeValidity(0, true);
    fan->setScanRange(1, std::numeric_limits<float>::quiet_NaN());
    const auto obs = SweepScan().asPointCloud(*fan, std::vector<uint8_t>{1, 1, 0}, {});
    const auto& cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*obs);
    EXPECT_EQ(cloud.timestamp, fan->timestamp);
    EXPECT_EQ(cloud.sensorLabel, "SWEEP");
    EXPECT_EQ(cloud.sensorPose, fan->sensorPose);
    EXPECT_TRUE(std::dynamic_pointer_cast<mrpt::maps::CSimplePointsMap>(cloud.pointcloud));
    ASSERT_EQ(cloud.pointcloud->size(), 1U);
    EXPECT_NEAR(cloud.pointcloud->getPointsBufferRef_x()[0], 1.5 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(cloud.pointcloud->getPointsBufferRef_y()[0], -1.5 * std::sqrt(0.5), 1e-6);
}

TEST(SweepScan, pointCloudHoldsIntensities) {
    const auto fan = fanIn(wallAhead(2), fanPose(0), {.aperture = 90, .rays = 3});
    fan->setScanHasIntensity(true);
    for (int i = 0; i < 3; ++i) fan->setScanIntensity(static_cast<size_t>(i), 100 + i);
    const auto obs = SweepScan().asPointCloud(*fan, std::vector<uint8_t>{0, 1, 1}, {});
    const auto& cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(*obs);
    const auto& map = dynamic_cast<const mrpt::maps::CPointsMapXYZI&>(*cloud.pointcloud);
    ASSERT_EQ(map.size(), 2U);
    EXPECT_EQ(map.getPointIntensity_fast(0), 101.0F);
    EXPECT_EQ(map.getPointIntensity_fast(1), 102.0F);
}

TEST(SweepScan, slotsAreRays) {
    EXPECT_EQ(SweepScan().slotCount(*fanIn(wallAhead(2), fanPose(0))), 171U);
    EXPECT_THROW(withOnly(*fanIn(wallAhead(2), fanPose(0)), {1}, Leftovers::Keep),
                 std::invalid_argument);
}

}  // namespace
}  // namespace offmap::rawlog
