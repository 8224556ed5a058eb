// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

/// An upright segment of 25 returns, 1 m to either side of the sensor's height.
WallSight sightAt(double groundRange, double azimuth = 0) {
    const TPoint2D beam(std::cos(azimuth), std::sin(azimuth));
    const TPoint2D place = beam * groundRange;
    return {.segment = 0,
            .place = {{0, 0}, {1, 0}},
            .lower = {place, -0.58},
            .upper = {place, 0.58},
            .beam = beam,
            .heightInMap = 1,
            .returns = 25};
}

SegmentMatch matchAt(double groundRange, const LineMap& map, const PoseCorrection& correction = {},
                     double azimuth = 0) {
    return matchByGate(sightAt(groundRange, azimuth), Interval(groundRange, groundRange),
                       correction, Turn(correction), map, {});
}

LineMap wallAhead() { return LineMap({{.line = {{4, -3}, {4, 3}}, .sigma = 0.01}}); }

}  // namespace

// 3 sigma of hypot(0.01 map, 0.02 / sqrt(15) range) = 3.38 cm, across the wall.
TEST(WallGate, isThreeSigmaWide) {
    const LineMap map = wallAhead();
    EXPECT_EQ(matchAt(4, map).verdict, Verdict::MappedByRay);
    EXPECT_EQ(matchAt(3.968, map).verdict, Verdict::MappedByRay);
    EXPECT_EQ(matchAt(4.032, map).verdict, Verdict::MappedByRay);
    EXPECT_EQ(matchAt(3.965, map).verdict, Verdict::Kept);
    EXPECT_EQ(matchAt(3.965, map).reason, KeepReason::InFrontOfWall);
    EXPECT_EQ(matchAt(4.035, map).reason, KeepReason::BehindWall);
    EXPECT_EQ(matchAt(3.9, map).wall, 0U);
}

TEST(WallGate, opensWithThePosesUncertaintyAcrossTheWallOnly) {
    const LineMap map = wallAhead();
    PoseCorrection across, along;
    across.covariance(0, 0) = along.covariance(1, 1) = 0.03 * 0.03;
    EXPECT_EQ(matchAt(3.93, map, across).verdict, Verdict::MappedByRay);  // 3 * 3.2 cm
    EXPECT_EQ(matchAt(3.93, map, along).verdict, Verdict::Kept);
}

// A turn by d moves a wall 4 m away and seen at 45 degrees by 4 m * d along the beam's normal,
// of which the wall's normal takes sin(45 degrees).
TEST(WallGate, opensWithTheHeadingByTheLeverOfTheWall) {
    const LineMap map = wallAhead();
    PoseCorrection turned;
    turned.covariance(2, 2) = 0.02 * 0.02;
    const double azimuth = std::numbers::pi / 4, range = 4 * std::sqrt(2.0);
    const WallOffset offset =
        offsetFrom(map, 0, turned, CorrectedColumn(turned, {{0, 0}, {1, 0}}),
                   sightAt(range, azimuth).middle(), sightAt(range, azimuth).beam, 0);
    EXPECT_NEAR(offset.sigma, std::hypot(0.01, 0.02 * range * std::sin(azimuth)), 1e-9);
    EXPECT_NEAR(offset.behind, 0, 1e-9);
}

TEST(WallGate, judgesWhereTheCorrectedPosePutsTheSegment) {
    PoseCorrection shifted;
    shifted.mean[0] = 0.2;
    EXPECT_EQ(matchAt(3.8, wallAhead(), shifted).verdict, Verdict::MappedByRay);
    EXPECT_EQ(matchAt(4.0, wallAhead(), shifted).reason, KeepReason::BehindWall);
}

TEST(WallGate, endsWhereTheWallEnds) {
    const LineMap map({{.line = {{4, -3}, {4, -0.1}}, .sigma = 0.01}});
    EXPECT_EQ(matchAt(4, map).verdict, Verdict::Kept) << "10 cm beside the wall's end";
    EXPECT_EQ(matchAt(4, map).reason, KeepReason::NoWallOnRay);
}

TEST(WallGate, residualAndPredictionTellTheSameStory) {
    const SegmentMatch match = matchAt(3.98, wallAhead());
    const double sigma = std::hypot(0.01, 0.02 / std::sqrt(15.0));
    EXPECT_NEAR(match.residual, -0.02 / sigma, 1e-9);
    ASSERT_TRUE(match.predicted);
    EXPECT_NEAR(match.predicted->centre(), 4, 1e-9);
    EXPECT_NEAR(match.predicted->width(), 2 * 3 * sigma, 1e-9);
}

// However uncertain the pose, what is 0.3 m off a wall is not of it.
TEST(WallGate, isNeverWiderThanThirtyCentimetres) {
    PoseCorrection lost;
    lost.covariance(0, 0) = 1;
    EXPECT_EQ(matchAt(3.75, wallAhead(), lost).verdict, Verdict::MappedByRay);
    EXPECT_EQ(matchAt(3.65, wallAhead(), lost).verdict, Verdict::Kept);
}

TEST(WallGate, isTheSameWithoutRoots) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-4, 4), small(-0.1, 0.1), noise(1e-6, 0.01);
    int within = 0, beyondAnEnd = 0;
    for (int i = 0; i < 20'000; ++i) {
        Wall wall{.line = {{place(random), place(random)}, {place(random), place(random)}}};
        if (i % 4 == 0) wall.curvature = place(random) / (2.1 * wall.line.length() + 4);
        const LineMap map({wall});
        PoseCorrection correction;
        Matrix5 root;
        for (int k = 0; k < 25; ++k) root(k) = small(random);
        for (int k = 0; k < 5; ++k) correction.mean[k] = small(random);
        correction.covariance = root * root.transpose();
        const CorrectedColumn column(correction, {{small(random), small(random)}, {0.6, 0.8}});
        const SeenPoint point{{place(random), place(random)}, place(random)};
        const double variance = noise(random), gate = 3;
        const TPoint2D beam = point.ground * (1 / point.ground.norm());
        const WallOffset offset = offsetFrom(map, 0, correction, column, point, beam, variance);
        const double distance = distanceTo(wall, column.place(point));
        constexpr double rounding = 1e-9;
        if (std::abs(distance - gate * offset.sigma) < rounding) continue;
        const bool expected = distance <= gate * offset.sigma;
        EXPECT_EQ(isWithinGate(map, 0, correction, column, point, variance, gate), expected);
        within += expected;
        beyondAnEnd += expected && distance > std::abs(offset.behind) + rounding;
    }
    EXPECT_GT(within, 2000);
    EXPECT_GT(beyondAnEnd, 200);
    const LineMap map({{.line = {{0, -1}, {0, 1}}}});  // through the sensor
    const PoseCorrection exact;
    EXPECT_TRUE(isWithinGate(map, 0, exact, {exact, {{0, 0}, {1, 0}}}, {{0, 0}, 0}, 1e-4, 3));
}

}  // namespace offmap::core
