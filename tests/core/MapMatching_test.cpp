// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/MapMatching.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

// At the origin, 1 m up, known to 5 cm along x and y.
Viewpoint viewpoint(double sigmaHeading = 0) {
    return {{0, 0}, 1, PositionEllipse(0.0025 * Eigen::Matrix2d::Identity()), sigmaHeading};
}

VerticalSegment segmentAt(const TPoint2D& centre) {
    VerticalSegment segment{};
    segment.centre = centre;
    segment.bottom = {centre.norm(), -1};
    segment.top = {centre.norm(), 1};
    return segment;
}

// A wall at x = 5, certain to 12 cm: together with the position, 13 cm; two sigmas are 26 cm.
const std::vector<Wall> wallAtFive{{{{5, -3}, {5, 3}}, 0.12}};
constexpr double twoSigmas = 0.26;
constexpr MatchingConfig config{.sigmaFactor = 2};

SegmentMatch matchByRay(const VerticalSegment& segment, const Interval& measured,
                        const Viewpoint& from, const LineMap& map, const MatchingConfig& by) {
    SegmentMatch match;
    match.measured = measured;
    core::matchByRay(segment, from, map, by, match);
    return match;
}

/// Eq. 7 as printed: an end point of the measured interval within the predicted one.
bool matchesAsPrinted(const Interval& measured, const Interval& predicted) {
    return predicted.contains(measured.min()) || predicted.contains(measured.max());
}

}  // namespace

TEST(MatchByRay, segmentAtTheWallIsMapped) {
    const LineMap map(wallAtFive);
    const auto match = matchByRay(segmentAt({5.02, 0}), {4.92, 5.12}, viewpoint(), map, config);
    EXPECT_EQ(match.verdict, Verdict::MappedByRay);
    EXPECT_EQ(match.reason, KeepReason::None);
    EXPECT_EQ(match.wall, 0u);
    EXPECT_EQ(match.measured, Interval(4.92, 5.12));
    ASSERT_TRUE(match.predicted);
    EXPECT_NEAR(match.predicted->min(), 5 - twoSigmas, 1e-14);
    EXPECT_NEAR(match.predicted->max(), 5 + twoSigmas, 1e-14);
    // 2 cm behind; the measured half-width of 10 cm counts as two sigmas.
    EXPECT_NEAR(match.residual, 0.02 / std::hypot(0.13, 0.05), 1e-12);
}

TEST(MatchByRay, nearerSegmentIsInFrontOfTheWall) {
    const LineMap map(wallAtFive);
    const auto match = matchByRay(segmentAt({4.6, 0}), {4.5, 4.7}, viewpoint(), map, config);
    EXPECT_EQ(match.verdict, Verdict::Kept);
    EXPECT_EQ(match.reason, KeepReason::InFrontOfWall);
    EXPECT_EQ(match.wall, 0u);
    EXPECT_NEAR(match.residual, -0.4 / std::hypot(0.13, 0.05), 1e-12);
}

TEST(MatchByRay, furtherSegmentIsBehindTheWall) {
    const LineMap map(wallAtFive);
    const auto match = matchByRay(segmentAt({5.4, 0}), {5.3, 5.5}, viewpoint(), map, config);
    EXPECT_EQ(match.verdict, Verdict::Kept);
    EXPECT_EQ(match.reason, KeepReason::BehindWall);
    EXPECT_GT(match.residual, 0);
}

TEST(MatchByRay, endsThatJustTouchMatch) {
    const LineMap map({{{{5, -3}, {5, 3}}, 0}});
    Viewpoint certain = viewpoint();
    certain.ellipse = PositionEllipse();
    EXPECT_TRUE(matchByRay(segmentAt({4.5, 0}), {4, 5}, certain, map, config).mapped());
    EXPECT_TRUE(matchByRay(segmentAt({5.5, 0}), {5, 6}, certain, map, config).mapped());
    EXPECT_FALSE(matchByRay(segmentAt({4.5, 0}), {4, 4.999}, certain, map, config).mapped());
    EXPECT_EQ(matchByRay(segmentAt({5, 0}), {5, 5}, certain, map, config).residual, 0);
}

TEST(MatchByRay, nothingOnTheRayIsKept) {
    const LineMap map(wallAtFive);
    const auto match = matchByRay(segmentAt({-5, 0}), {4.9, 5.1}, viewpoint(), map, config);
    EXPECT_EQ(match.verdict, Verdict::Kept);
    EXPECT_EQ(match.reason, KeepReason::NoWallOnRay);
    EXPECT_FALSE(match.wall);
    EXPECT_FALSE(match.predicted);
    EXPECT_EQ(match.residual, 0);
}

TEST(MatchByRay, wallBeyondMaxRangeIsNone) {
    MatchingConfig near = config;
    near.maxRange = 4.9;
    const auto match =
        matchByRay(segmentAt({5, 0}), {4.8, 5.2}, viewpoint(), LineMap(wallAtFive), near);
    EXPECT_EQ(match.reason, KeepReason::NoWallOnRay);
}

TEST(MatchByRay, measuredIntervalAroundThePredictedOneMatches) {
    // Eq. 7 as printed asks whether an end point lies inside, and refuses this.
    const auto match =
        matchByRay(segmentAt({5, 0}), {4.5, 5.5}, viewpoint(), LineMap(wallAtFive), config);
    EXPECT_EQ(match.verdict, Verdict::MappedByRay);
    ASSERT_TRUE(match.predicted);
    EXPECT_TRUE(match.measured.contains(*match.predicted));
    EXPECT_FALSE(matchesAsPrinted(match.measured, *match.predicted));
}

TEST(MatchByRay, ellipseCountsInTheDirectionOfTheRay) {
    Viewpoint oblong = viewpoint();
    oblong.ellipse = PositionEllipse(Eigen::Vector2d(0.05 * 0.05, 0.16 * 0.16).asDiagonal());
    const LineMap map({{{{5, -3}, {5, 3}}, 0.12}, {{{-3, 5}, {3, 5}}, 0.12}});
    EXPECT_NEAR(matchByRay(segmentAt({5, 0}), {5, 5}, oblong, map, config).predicted->width(),
                4 * 0.13, 1e-14);
    EXPECT_NEAR(matchByRay(segmentAt({0, 5}), {5, 5}, oblong, map, config).predicted->width(),
                4 * 0.20, 1e-14);
}

TEST(MatchByRay, heightOfTheSegmentChoosesTheWall) {
    const LineMap map({{{{5, -3}, {5, 3}}, 0.03, {3, 4}}, {{{8, -3}, {8, 3}}, 0.03}});
    VerticalSegment high = segmentAt({5, 0});
    EXPECT_EQ(matchByRay(high, {4.9, 5.1}, viewpoint(), map, config).wall, 1u);
    high.bottom.y = 2;
    high.top.y = 3;  // 3 to 4 m in the map, the sensor being 1 m up
    EXPECT_EQ(matchByRay(high, {4.9, 5.1}, viewpoint(), map, config).wall, 0u);
}

TEST(MatchByRay, jumpEdgeWithinTheHeadingIsAmbiguous) {
    // The wall at 5 m ends at y = 0; beyond it stands one at 8 m. A segment at 8 m, seen just on
    // the nearer wall's side of the edge, fits the far wall if the heading is off by 0.5 degrees.
    const LineMap map({{{{5, -3}, {5, 0}}, 0.03}, {{{8, -3}, {8, 3}}, 0.03}});
    const VerticalSegment segment = segmentAt({8, -0.05});
    const Interval measured(7.95, 8.05);
    const auto certain = matchByRay(segment, measured, viewpoint(0), map, config);
    EXPECT_EQ(certain.reason, KeepReason::BehindWall);
    EXPECT_EQ(certain.wall, 0u);
    const double tooLittle = 0.05 / 8 / 2 * 0.9;
    EXPECT_EQ(matchByRay(segment, measured, viewpoint(tooLittle), map, config).reason,
              KeepReason::BehindWall);
    const auto ambiguous = matchByRay(segment, measured, viewpoint(0.0087), map, config);
    EXPECT_EQ(ambiguous.verdict, Verdict::Kept);
    EXPECT_EQ(ambiguous.reason, KeepReason::AmbiguousCorner);
    EXPECT_EQ(ambiguous.wall, 1u);
    EXPECT_EQ(matchByRay(segment, {6.4, 6.6}, viewpoint(0.0087), map, config).reason,
              KeepReason::BehindWall);  // fits neither
}

TEST(MatchByRay, wallThatTheRayJustMissesIsAmbiguous) {
    const LineMap map({{{{5, -3}, {5, 0}}, 0.03}});
    const auto match =
        matchByRay(segmentAt({5, 0.05}), {4.95, 5.05}, viewpoint(0.0087), map, config);
    EXPECT_EQ(match.reason, KeepReason::AmbiguousCorner);
    EXPECT_EQ(match.wall, 0u);
    EXPECT_FALSE(match.predicted);
}

RC_GTEST_PROP(MatchByRayLaws, largerCovarianceNeverUnmatches, ()) {
    const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
    std::vector<Wall> walls;
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
        const TPoint2D from(number(-900, 900), number(-900, 900));
        const TPoint2D along(number(1, 900), number(-900, 900));
        walls.push_back({{from, from + along}, number(0, 10)});
    }
    const LineMap map(std::move(walls));
    const double range = number(100, 900), angle = number(-314, 314);
    const VerticalSegment segment = segmentAt({range * std::cos(angle), range * std::sin(angle)});
    const Interval measured = Interval::around(range, number(0, 20));
    Eigen::Matrix2d root, more;
    for (int i = 0; i < 4; ++i) {
        root(i) = number(-20, 20);
        more(i) = number(-20, 20);
    }
    const Eigen::Matrix2d small = root * root.transpose(), large = small + more * more.transpose();
    const double heading = number(0, 10);
    const Viewpoint before{{0, 0}, 1, PositionEllipse(small), heading};
    const Viewpoint after{{0, 0}, 1, PositionEllipse(large), heading + number(0, 10)};
    const bool mapped = matchByRay(segment, measured, before, map, config).mapped();
    RC_CLASSIFY(mapped);
    if (mapped) RC_ASSERT(matchByRay(segment, measured, after, map, config).mapped());
}

TEST(FaultOf, limitsWhatIsTooUncertain) {
    MatchingConfig limits = config;
    limits.method = MatchingMethod::Paper;
    limits.maxPositionRadius = 0.5;
    limits.maxHeadingError = mrpt::DEG2RAD(15.0);
    EXPECT_FALSE(faultOf(viewpoint(mrpt::DEG2RAD(7.4)), limits));
    EXPECT_EQ(faultOf(viewpoint(mrpt::DEG2RAD(7.6)), limits), PoseFault::TooUncertain);
    Viewpoint vague = viewpoint();
    vague.ellipse = PositionEllipse(Eigen::Vector2d(0.24 * 0.24, 0).asDiagonal());
    EXPECT_FALSE(faultOf(vague, limits));
    vague.ellipse = PositionEllipse(Eigen::Vector2d(0, 0.26 * 0.26).asDiagonal());
    EXPECT_EQ(faultOf(vague, limits), PoseFault::TooUncertain);
    limits.method = MatchingMethod::Aligned;
    EXPECT_FALSE(faultOf(vague, limits)) << "the scan will tell more";
}

TEST(FaultOf, poseThatIsNotFiniteIsFound) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int field = 0; field < 6; ++field) {
        SensorPose sensor;
        std::array<double, 3> position{0, 0, 0};
        if (field < 3) position[static_cast<size_t>(field)] = nan;
        sensor.sensorInMap.setFromValues(position[0], position[1], position[2]);
        if (field >= 3) sensor.groundCovariance(field - 3, field - 3) = nan;
        EXPECT_EQ(faultOf(viewpointOf(sensor), config), PoseFault::NotFinite) << "field " << field;
    }
}

TEST(ViewpointOf, takesThePlaneOfTheMap) {
    SensorPose sensor;
    sensor.sensorInMap.setFromValues(1, 2, 3, 0.5, 0.1, 0.2);
    sensor.groundCovariance = Eigen::Vector3d(0.01, 0.0025, 0.0004).asDiagonal();
    const Viewpoint view = viewpointOf(sensor);
    EXPECT_EQ(view.position, TPoint2D(1, 2));
    EXPECT_EQ(view.height, 3);
    EXPECT_DOUBLE_EQ(view.ellipse.radius({1, 0}), 0.1);
    EXPECT_DOUBLE_EQ(view.ellipse.radius({0, 1}), 0.05);
    EXPECT_DOUBLE_EQ(view.sigmaHeading, 0.02);
}

}  // namespace offmap::core
