// SPDX-License-Identifier: BSD-3-Clause
#include "SmallScan.h"

#include <offmap/view/PlacedReturns.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace offmap::view {
namespace {

TEST(PlacedReturns, everyReturnStandsWhereItsColumnsSensorPutsIt) {
    const SmallScan s;
    const PlacedReturns placed = placedReturns(s.scan, s.result.labels);
    ASSERT_EQ(placed.points.size(), 33U);
    ASSERT_EQ(placed.sensorPath.size(), 3U);
    constexpr float rounding = 4e-6F;  // two units in the last place of a float near 20
    EXPECT_NEAR(placed.points[0].x, 6, rounding);
    EXPECT_NEAR(placed.points[0].y, 20, rounding);
    EXPECT_NEAR(placed.points[0].z, 0, rounding);
    EXPECT_NEAR(placed.points[32].x, 10, rounding);
    EXPECT_NEAR(placed.points[32].y, 24, rounding);
    EXPECT_NEAR(placed.points[32].z, 2, rounding);
    EXPECT_EQ(placed.labels[0], core::PointLabel::Mapped);
    EXPECT_EQ(placed.labels[32], core::PointLabel::NotOnVerticalSegment);
}

TEST(PlacedReturns, columnsWithoutAPoseAreLeftOut) {
    SmallScan s;
    s.scan.columns[0].sensor.reset();
    const PlacedReturns placed = placedReturns(s.scan, s.result.labels);
    EXPECT_EQ(placed.points.size(), 22U);
    EXPECT_EQ(placed.labels.front(), core::PointLabel::Kept);
}

TEST(PlacedReturns, columnsWithoutAPoseFollowTheFallback) {
    SmallScan s;
    s.scan.columns[0].sensor.reset();
    const PlacedReturns placed =
        placedReturns(s.scan, s.result.labels, mrpt::poses::CPose3D(1, 2, 3, 0, 0, 0));
    ASSERT_EQ(placed.points.size(), 33U);
    EXPECT_EQ(placed.points[0], (mrpt::math::TPoint3Df{1, 6, 2}));
}

TEST(PlacedReturns, missingLabelsAreRefused) {
    SmallScan s;
    s.result.labels.pop_back();
    EXPECT_THROW(placedReturns(s.scan, s.result.labels), std::invalid_argument);
}

TEST(ExtentOf, farOutliersDoNotWidenIt) {
    PlacedReturns returns;
    for (int i = 0; i <= 100; ++i) {
        returns.points.emplace_back(static_cast<float>(i), 0.1F * static_cast<float>(i), 0.0F);
        returns.labels.push_back(core::PointLabel::NotOnVerticalSegment);
    }
    returns.points[3] = {5000, -3000, 800};
    const auto extent = extentOf(returns);
    // 101 returns: the five outermost to each side are left out. Without the third, the sixth
    // lowest x is 6; the outlier is one of the five highest.
    EXPECT_EQ(extent.min.x, 6);
    EXPECT_EQ(extent.max.x, 96);
    EXPECT_EQ(extent.max.z - extent.min.z, 2);
}

TEST(ExtentOf, fewMappedReturnsFarAwayAreInIt) {
    PlacedReturns returns;
    returns.points.assign(1000, {0, 0, 0});
    returns.labels.assign(1000, core::PointLabel::Kept);
    returns.points[7] = {30, 0, 0};
    returns.labels[7] = core::PointLabel::Mapped;
    EXPECT_EQ(extentOf(returns).max.x, 30);
}

TEST(ExtentOf, nothingHasASmallExtentAboutTheOrigin) {
    const auto extent = extentOf({});
    EXPECT_EQ(extent.min, (mrpt::math::TPoint3D{-1, -1, -1}));
    EXPECT_EQ(extent.max, (mrpt::math::TPoint3D{1, 1, 1}));
}

}  // namespace
}  // namespace offmap::view
