// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/VerticalSegments.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace offmap::core {

namespace {

constexpr double degree = mrpt::DEG2RAD(1.0);

/// The interval of a segment whose points are those of a profile, (ground range, z).
Interval intervalOf(const std::vector<mrpt::math::TPoint2D>& profile, double maxMountingTilt) {
    using mrpt::math::TPoint2D;
    const auto [nearest, furthest] = std::ranges::minmax(profile, {}, &TPoint2D::x);
    const auto [lowest, highest] = std::ranges::minmax(profile, {}, &TPoint2D::y);
    VerticalSegment segment{};
    segment.nearest = nearest.x;
    segment.furthest = furthest.x;
    segment.lowest = lowest.y;
    segment.highest = highest.y;
    return groundInterval(segment, std::tan(maxMountingTilt));
}

}  // namespace

TEST(GroundInterval, wallOfThreeMetresSeenFromTheGroundErrsByTenCentimetres) {
    // The paper's example: 2 degrees, 3 m, scanner on the ground: 3 m x tan(2 deg) = 0.1048 m.
    const Interval interval = intervalOf({{5, 0}, {5, 1.5}, {5, 3}}, 2 * degree);
    EXPECT_NEAR(interval.min(), 5 - 0.10476, 5e-6);
    EXPECT_NEAR(interval.max(), 5 + 0.10476, 5e-6);
}

TEST(GroundInterval, spansThePointsWhereTheMountingIsUpright) {
    const Interval interval = intervalOf({{4.97, -1}, {5.02, 0}, {4.99, 1}}, 0);
    EXPECT_EQ(interval, Interval(4.97, 5.02));  // eq. 3
}

TEST(GroundInterval, endFurthestAboveOrBelowTheSensorCounts) {
    const double tilt = std::atan(0.125);
    EXPECT_NEAR(intervalOf({{5, -2}, {5, 1}}, tilt).width(), 2 * 0.25, 1e-15);
    EXPECT_NEAR(intervalOf({{5, -1}, {5, 2}}, tilt).width(), 2 * 0.25, 1e-15);
    EXPECT_NEAR(intervalOf({{5, 2}, {5, 1}}, tilt).width(), 2 * 0.25, 1e-15);
}

}  // namespace offmap::core
