// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/PlanCheck.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace offmap::evaluation {

using mrpt::math::TPoint2D;

namespace {

constexpr double rounding = 1e-9;  // [m]

/// A fan of beams from the sensor to a line from a to b; every 2 cm along it, one column each.
/// \param offset [m] across the line, to its left, at a share of the way
std::vector<SeenSegment> lookAt(const TPoint2D& sensor, const TPoint2D& a, const TPoint2D& b,
                                const std::function<double(double)>& offset = {},
                                double height = 2.5) {
    constexpr double spacing = 0.02;  // [m]
    const TPoint2D way = b - a;
    const TPoint2D left = TPoint2D(-way.y, way.x) * (1 / way.norm());
    const auto count = static_cast<uint32_t>(way.norm() / spacing);
    std::vector<SeenSegment> segments;
    for (uint32_t i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count;
        const TPoint2D place = a + way * share + left * (offset ? offset(share) : 0);
        segments.push_back(
            {i, sensor, place, Eigen::Matrix2d::Zero(), core::Interval(0, height), 20, false});
    }
    return segments;
}

/// Along x = 2, upwards: a sensor at the origin is to its left.
const core::LineMap& oneWall() {
    static const core::LineMap map({{.line = {{2, -1}, {2, 1}}}});
    return map;
}

WallCheck checkOf(const std::vector<SeenSegment>& segments, const core::LineMap& map = oneWall(),
                  uint32_t wall = 0) {
    PlanCheck check(map, {});
    check.add(segments);
    return check.walls().at(wall);
}

}  // namespace

TEST(PlanCheck, surfaceBehindTheDrawnWallIsPositive) {
    const WallCheck wall = checkOf(lookAt({0, 0}, {2.2, -1}, {2.2, 1}));
    EXPECT_NEAR(wall.seen, 1, rounding);
    EXPECT_NEAR(wall.offset.mean(), 0.2, rounding);
    EXPECT_NEAR(wall.rms, 0.2, rounding);
    EXPECT_NEAR(wall.largest, 0.2, rounding);
    EXPECT_NEAR(wall.spread, 0, 1e-6);  // the root of rounding in squares
    ASSERT_TRUE(wall.leftFace);
    EXPECT_NEAR(*wall.leftFace, -0.2, rounding) << "to the right of the wall's way";
    EXPECT_FALSE(wall.rightFace);
    EXPECT_EQ(wall.bins.size(), 8U);
    EXPECT_EQ(wall.offset.segments, 100U);
    EXPECT_EQ(wall.offset.returns, 2000U);
}

TEST(PlanCheck, bothFacesOfAThickWallAreTold) {
    PlanCheck check(oneWall(), {});
    check.add(lookAt({0, 0}, {1.95, -1}, {1.95, 1}));
    check.add(lookAt({4, 0}, {2.07, -1}, {2.07, 1}));
    const WallCheck wall = check.walls().at(0);
    EXPECT_NEAR(wall.leftFace.value(), 0.05, rounding);
    EXPECT_NEAR(wall.rightFace.value(), -0.07, rounding);
    EXPECT_NEAR(wall.offset.mean(), -0.06, rounding) << "both stand before the line";
}

TEST(PlanCheck, bendShowsInTheBins) {
    const auto bend = [](double share) { return 0.05 * std::sin(std::numbers::pi * share); };
    const WallCheck wall = checkOf(lookAt({0, 0}, {2, -1}, {2, 1}, bend));
    ASSERT_EQ(wall.bins.size(), 8U);
    for (const BinCheck& bin : wall.bins) {
        ASSERT_EQ(bin.state, BinState::Seen);
        // The segments of a bin may stand half their spacing of 2 cm to one side, on a slope of
        // at most 0.05 pi / 2: 0.8 mm. The bend's own curvature adds 0.05 (pi / 2)^2 times the
        // bin's square / 24 = 0.3 mm.
        EXPECT_NEAR(bin.offset.mean(), -bend(0.5 * (bin.from + bin.to) / wall.length), 1.1e-3);
    }
    // Half a bin from the middle the bend is 0.05 cos(pi / 16), 1 mm less; and as above.
    EXPECT_NEAR(wall.largest, -0.05, 0.0021);
    EXPECT_NEAR(wall.largestAt, 1, 0.13);  // one of the two bins beside the middle
}

TEST(PlanCheck, wallThatIsLookedThroughIsMissing) {
    // What lies behind is seen through the wall in 2 / 3 of its own length.
    const WallCheck wall = checkOf(lookAt({0, 0}, {3, -1.5}, {3, 1.5}));
    EXPECT_EQ(wall.seen, 0);
    EXPECT_NEAR(wall.missing, 1, rounding);
    EXPECT_EQ(wall.through, 150U);
    EXPECT_EQ(wall.offset.segments, 0U);
}

TEST(PlanCheck, wallBehindThingsIsHidden) {
    const WallCheck wall = checkOf(lookAt({0, 0}, {1, -0.5}, {1, 0.5}));
    EXPECT_NEAR(wall.hidden, 1, rounding);
    EXPECT_NEAR(wall.clearance, 1, rounding) << "[m] across the wall";
    EXPECT_EQ(wall.inFront, 50U);
}

TEST(PlanCheck, wallThatNoBeamMeetsIsOutOfView) {
    const WallCheck wall = checkOf(lookAt({0, 0}, {-1, -1}, {-1, 1}));
    EXPECT_EQ(wall.seen + wall.missing + wall.hidden, 0);
    EXPECT_EQ(wall.bins.at(0).state, BinState::OutOfView);
}

TEST(PlanCheck, thingAtTheWallIsNoBendOfIt) {
    auto segments = lookAt({0, 0}, {2, -1}, {2, 0.5});
    const auto thing = lookAt({0, 0}, {1.75, 0.5}, {1.75, 1});
    for (SeenSegment segment : thing) {
        segment.column += static_cast<uint32_t>(segments.size());
        segments.push_back(segment);
    }
    const WallCheck wall = checkOf(segments);
    EXPECT_NEAR(wall.seen, 0.75, rounding);
    EXPECT_NEAR(wall.hidden, 0.25, rounding);
    EXPECT_NEAR(wall.largest, 0, rounding);
    EXPECT_NEAR(wall.clearance, 0.25, rounding);
}

TEST(PlanCheck, surfaceBelongsToTheWallItRunsAlong) {
    // The surface of the long wall, 10 cm behind, passes nearer to the short one at its end.
    const core::LineMap map({{.line = {{2, -1}, {2, 1}}}, {.line = {{2, 1}, {2.2, 1}}}});
    PlanCheck check(map, {});
    check.add(lookAt({0, 0}, {2.1, -1}, {2.1, 1}));
    EXPECT_NEAR(check.walls()[0].offset.mean(), 0.1, rounding);
    EXPECT_NEAR(check.walls()[0].seen, 1, rounding);
    EXPECT_EQ(check.walls()[1].seen, 0);
}

TEST(PlanCheck, lowWallIsNotWhatIsSeenAboveIt) {
    const core::LineMap map({{.line = {{2, -1}, {2, 1}}, .height = {0, 1}}});
    const WallCheck above = checkOf(lookAt({0, 0}, {2, -1}, {2, 1}, {}, 2.5), map);
    EXPECT_EQ(above.seen, 0) << "the segments' middles are at 1.25 m";
    const WallCheck onIt = checkOf(lookAt({0, 0}, {2, -1}, {2, 1}, {}, 0.9), map);
    EXPECT_NEAR(onIt.seen, 1, rounding);
}

TEST(PlanCheck, arcIsCheckedAlongItsCurve) {
    // A quarter of a circle of 2 m about the origin, built 3 cm too large.
    const double radius = 2, chord = radius * std::sqrt(2.0);
    const core::LineMap map({{.line = {{radius, 0}, {0, radius}}, .curvature = 1 / radius}});
    const auto bulge = [&](double share) {
        const double along = (share - 0.5) * chord, built = radius + 0.03;
        return -(std::sqrt(built * built - along * along) - chord / 2);
    };
    const WallCheck wall = checkOf(lookAt({0, 0}, {radius, 0}, {0, radius}, bulge), map);
    EXPECT_NEAR(wall.length, std::numbers::pi / 2 * radius, rounding);
    EXPECT_NEAR(wall.seen, 1, rounding);
    EXPECT_NEAR(wall.offset.mean(), 0.03, rounding);
    EXPECT_NEAR(wall.leftFace.value(), -0.03, rounding);
}

TEST(PlanCheck, oneSegmentAloneShowsNoWall) {
    const WallCheck wall = checkOf({lookAt({0, 0}, {2, -1}, {2, 1}).front()});
    EXPECT_EQ(wall.seen, 0);
}

}  // namespace offmap::evaluation
