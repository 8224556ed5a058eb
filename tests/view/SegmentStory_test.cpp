// SPDX-License-Identifier: BSD-3-Clause
#include "SmallSegments.h"

#include <offmap/view/SegmentStory.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace offmap::view {
namespace {

using core::KeepReason;
using core::PointLabel;
using core::PoseFault;
using core::Verdict;
using testing::HasSubstr;

std::map<std::string, std::string> told(const SmallSegments& s, uint32_t point) {
    const auto lines = linesOf(storyOf(s.scan, s.result, point), s.map);
    return {lines.begin(), lines.end()};
}

std::string why(const SmallSegments& s, uint32_t point) {
    const auto lines = linesOf(storyOf(s.scan, s.result, point), s.map);
    EXPECT_EQ(lines.back().first, "why");
    return lines.back().second;
}

TEST(SegmentStory, pointsOfASegmentFindIt) {
    core::ReductionResult result;
    for (const auto& [begin, end] : {std::pair(2U, 5U), std::pair(5U, 6U), std::pair(9U, 12U)}) {
        core::VerticalSegment segment{};
        segment.begin = begin;
        segment.end = end;
        result.segments.push_back(segment);
    }
    const std::map<uint32_t, std::optional<uint32_t>> expected{
        {0, {}}, {1, {}}, {2, 0}, {4, 0}, {5, 1}, {6, {}}, {8, {}}, {9, 2}, {11, 2}, {12, {}}};
    for (const auto& [point, segment] : expected) EXPECT_EQ(segmentOf(result, point), segment);
    EXPECT_EQ(segmentOf({}, 0), std::nullopt);
}

// The small scan's second pole: 4 m to the right of a sensor at (10, 20, 1) that looks along y.
TEST(SegmentStory, holdsWhatBecameOfTheReturn) {
    SmallSegments s;
    s.result.labels[12] = PointLabel::Mapped;
    const SegmentStory story = storyOf(s.scan, s.result, 11);
    EXPECT_EQ(story.point, 11U);
    EXPECT_EQ(story.column, 1U);
    EXPECT_EQ(story.segment, 1U);
    EXPECT_EQ(story.label, PointLabel::Kept);
    EXPECT_FLOAT_EQ(static_cast<float>(story.range), std::sqrt(17.0F));
    ASSERT_TRUE(story.inMap);
    EXPECT_NEAR(story.inMap->x, 14, 1e-9);  // rounding of sines only
    EXPECT_NEAR(story.inMap->y, 20, 1e-9);
    EXPECT_NEAR(story.inMap->z, 0, 1e-9);
    EXPECT_EQ(story.heights, core::Interval(0, 2)) << "1 m below the sensor to 1 m above it";
    EXPECT_EQ(story.measured, core::Interval(3.95, 4.05));
    EXPECT_EQ(story.wall, 0U);
    EXPECT_EQ(story.reason, KeepReason::InFrontOfWall);
    EXPECT_EQ(story.returns, 11U);
    EXPECT_EQ(story.removed, 1U);
    EXPECT_FALSE(story.fault);
}

TEST(SegmentStory, isToldWithUnits) {
    const SmallSegments s;
    auto mapped = told(s, 0);
    EXPECT_EQ(mapped["return"], "4.123 m away, at (6.00, 20.00, 0.00) m");
    EXPECT_EQ(mapped["fate"], "removed: mapped");
    EXPECT_EQ(mapped["column"], "0 at 90.0 deg");
    EXPECT_EQ(mapped["segment"], "0, 11 returns, 11 removed");
    EXPECT_EQ(mapped["height"], "0.000 ... 2.000 m");
    EXPECT_EQ(mapped["measured"], "3.950 ... 4.050 m");
    EXPECT_EQ(mapped["predicted"], "3.900 +- 0.120 m, wall 0");
    EXPECT_EQ(mapped["verdict"], "mapped by ray, 2.5 sigma behind");
    EXPECT_EQ(mapped["wall"], "0: (6.00, 16.00) to (14.00, 16.00) m, sigma 0.030 m");
    EXPECT_EQ(mapped["why"],
              "It stands on wall 0, 0.10 m behind it, which is 2.5 standard deviations: the map "
              "knows it.");
    EXPECT_EQ(told(s, 11)["verdict"], "kept: in front of a wall, 5.0 sigma in front");
    EXPECT_EQ(why(s, 11),
              "It stands 0.50 m in front of wall 0, which is 5.0 standard deviations: not the "
              "wall.");
}

TEST(SegmentStory, explainsWhyASegmentIsKept) {
    SmallSegments s;
    core::SegmentMatch& match = s.result.matches[1];
    match.predicted = core::Interval(3.9, 4.3);  // holds 4.0, where it was measured
    EXPECT_THAT(why(s, 11), HasSubstr("but the wall itself is not there"));
    match.predicted.reset();
    EXPECT_THAT(why(s, 11), HasSubstr("only grazes wall 0"));
    match.reason = KeepReason::AmbiguousCorner;
    EXPECT_THAT(why(s, 11), HasSubstr("fits wall 0 only if the heading is wrong"));
    match.reason = KeepReason::NoWallOnRay;
    match.wall.reset();
    EXPECT_EQ(why(s, 11), "No wall lies in this direction.");
    EXPECT_EQ(told(s, 11)["predicted"], "no wall");
    EXPECT_EQ(told(s, 11).count("wall"), 0U);
}

TEST(SegmentStory, explainsWhyASegmentIsRemoved) {
    SmallSegments s;
    core::SegmentMatch& match = s.result.matches[0];
    match.verdict = Verdict::MappedByExtension;
    EXPECT_EQ(why(s, 0), "It continues the line of mapped segments along wall 0.");
    EXPECT_EQ(told(s, 0)["verdict"], "mapped by extension");
    EXPECT_THAT(told(s, 0)["predicted"], HasSubstr("another wall")) << "that of the ray";
    match.verdict = Verdict::RemovedAsOrphan;
    s.result.labels[0] = PointLabel::Orphan;
    EXPECT_THAT(why(s, 0), HasSubstr("No other segment stands beside it"));
}

TEST(SegmentStory, explainsReturnsThatWereJudgedByThemselves) {
    SmallSegments s;
    EXPECT_EQ(why(s, 22), "Not on a vertical segment: neither wall nor object edge; always kept.");
    EXPECT_EQ(told(s, 22).count("segment"), 0U);
    s.result.labels[22] = PointLabel::Mapped;
    EXPECT_THAT(why(s, 22), HasSubstr("On no vertical segment, but it lies on a wall"));
    s.result.labels[0] = PointLabel::Kept;
    EXPECT_EQ(why(s, 0),
              "Its segment was matched to wall 0, but this return stands off the wall: kept.");
}

TEST(SegmentStory, tellsTheFaultOfThePose) {
    SmallSegments s;
    s.result.labels[0] = PointLabel::Kept;
    s.result.matches[0] = {};
    s.scan.columns[0].sensorInVehicle.z = 1;
    s.scan.columns[0].sensor->groundCovariance(0, 0) = 100;
    EXPECT_EQ(why(s, 0), "The pose is too uncertain: any segment would fit some wall: kept.");
    s.scan.columns[0].sensor->groundCovariance(0, 0) = std::numeric_limits<double>::infinity();
    EXPECT_EQ(why(s, 0), "The pose or its covariance is not finite: kept.");
    s.scan.columns[0].sensor.reset();
    s.scan.columns[0].fault = PoseFault::TooOld;
    EXPECT_EQ(why(s, 0), "The nearest pose is too far away in time: kept.");
    EXPECT_EQ(told(s, 0)["return"], "4.123 m away") << "nowhere in the map";
    EXPECT_EQ(told(s, 0)["height"], "0.000 ... 2.000 m") << "above the vehicle";
    EXPECT_EQ(told(s, 0).count("predicted"), 0U);
    s.result.notReduced = PoseFault::DoesNotFit;
    EXPECT_THAT(why(s, 22), HasSubstr("fits the map nowhere"));
}

TEST(SegmentStory, otherPointsAreRefused) {
    SmallSegments s;
    EXPECT_THROW(storyOf(s.scan, s.result, 33), std::out_of_range);
    s.result.labels.pop_back();
    EXPECT_THROW(storyOf(s.scan, s.result, 0), std::out_of_range);
    EXPECT_THROW(storyOf({}, {}, 0), std::out_of_range);
}

}  // namespace
}  // namespace offmap::view
