// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/VerticalSegments.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace offmap::core {

namespace {

constexpr double degree = mrpt::DEG2RAD(1.0);

/// \param profile (ground range, z)
LevelledScan levelledOf(const std::vector<mrpt::math::TPoint2D>& profile) {
    LevelledScan levelled;
    for (const auto& [range, z] : profile) {
        levelled.range.push_back(static_cast<float>(range));
        levelled.z.push_back(static_cast<float>(z));
    }
    return levelled;
}

/// The interval of a segment that holds all points of a profile, (ground range, z).
Interval intervalOf(const std::vector<mrpt::math::TPoint2D>& profile, double maxMountingTilt) {
    VerticalSegment segment{};
    segment.end = static_cast<uint32_t>(profile.size());
    return groundInterval(segment, levelledOf(profile), std::tan(maxMountingTilt));
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
    EXPECT_EQ(interval, Interval(4.97F, 5.02F));  // eq. 3
}

TEST(GroundInterval, endFurthestAboveOrBelowTheSensorCounts) {
    const double tilt = std::atan(0.125);
    EXPECT_NEAR(intervalOf({{5, -2}, {5, 1}}, tilt).width(), 2 * 0.25, 1e-15);
    EXPECT_NEAR(intervalOf({{5, -1}, {5, 2}}, tilt).width(), 2 * 0.25, 1e-15);
    EXPECT_NEAR(intervalOf({{5, 2}, {5, 1}}, tilt).width(), 2 * 0.25, 1e-15);
}

TEST(GroundInterval, looksAtTheSegmentAlone) {
    const LevelledScan levelled = levelledOf({{1, 9}, {5, 0}, {5.25, 0}, {9, -9}});
    VerticalSegment segment{};
    segment.begin = 1;
    segment.end = 3;
    EXPECT_EQ(groundInterval(segment, levelled, std::tan(2 * degree)), Interval(5, 5.25));
}

}  // namespace offmap::core
