// SPDX-License-Identifier: BSD-3-Clause
#include "SmallSegments.h"

#include <offmap/view/SegmentMarks.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace offmap::view {
namespace {

constexpr double width = 0.04 + 0.015 * 4;  // [m] of the marks on the floor, at 4 m
constexpr double single = 1e-5;             // [m] rounding of single precision at 20 m

// The second segment stands at map x = 14, from the floor to 2 m; the sensor at (10, 20, 1).
TEST(SegmentMarks, standWhereTheSegmentDoes) {
    const SmallSegments s;
    const auto marks = segmentMarksOf(s.scan, s.result, s.map, 1, {});
    EXPECT_EQ(marks->getName(), "segment");
    const auto line = marks->getByName("line")->getBoundingBox();
    EXPECT_NEAR(line.min.x, 14, single);
    EXPECT_NEAR(line.max.x, 14, single);
    EXPECT_NEAR(line.min.z, 0, single);
    EXPECT_NEAR(line.max.z, 2, single);
    const auto returns = marks->getByName("returns")->getBoundingBox();
    EXPECT_NEAR(returns.min.x, 14, single);
    EXPECT_NEAR(returns.max.y, 20, single);
    EXPECT_NEAR(returns.max.z, 2, single);
}

TEST(SegmentMarks, intervalsLieOnTheFloorSideBySide) {
    const SmallSegments s;
    const auto marks = segmentMarksOf(s.scan, s.result, s.map, 1, {});
    const auto measured = marks->getByName("measured")->getBoundingBox();
    const auto predicted = marks->getByName("predicted")->getBoundingBox();
    EXPECT_NEAR(measured.min.x, 10 + 3.95, single);
    EXPECT_NEAR(measured.max.x, 10 + 4.05, single);
    EXPECT_NEAR(predicted.min.x, 10 + 4.2, single);
    EXPECT_NEAR(predicted.max.x, 10 + 4.8, single);
    for (const auto& box : {measured, predicted}) {
        EXPECT_NEAR(box.min.z, 0, single);
        EXPECT_NEAR(box.max.z, width, single);
        EXPECT_NEAR(box.max.y - box.min.y, width, 2 * single);
    }
    EXPECT_GT(measured.min.y, predicted.max.y);
    const auto beam = marks->getByName("beam")->getBoundingBox();
    EXPECT_NEAR(beam.min.x, 10, single);
    EXPECT_NEAR(beam.max.x, 10 + 3.95, single);
}

TEST(SegmentMarks, wallIsLitUpToItsOwnHeight) {
    const SmallSegments s;
    const auto wall = segmentMarksOf(s.scan, s.result, s.map, 1, {})->getByName("wall");
    ASSERT_TRUE(wall);
    const auto box = wall->getBoundingBox();
    EXPECT_NEAR(box.min.x, 6, single);
    EXPECT_NEAR(box.max.x, 14, single);
    EXPECT_NEAR(box.max.z, 2, single);
}

TEST(SegmentMarks, whatThereIsNoneOfIsLeftOut) {
    SmallSegments s;
    s.result.matches[1].predicted.reset();
    s.result.matches[1].wall = 7;  // of another map
    auto marks = segmentMarksOf(s.scan, s.result, s.map, 1, {});
    EXPECT_FALSE(marks->getByName("predicted"));
    EXPECT_FALSE(marks->getByName("wall"));
    EXPECT_TRUE(marks->getByName("measured"));
    s.scan.columns[1].sensor.reset();
    EXPECT_TRUE(segmentMarksOf(s.scan, s.result, s.map, 1, {})->empty());
    marks = segmentMarksOf(s.scan, s.result, s.map, 1, {}, mrpt::poses::CPose3D());
    EXPECT_NEAR(marks->getByName("line")->getBoundingBox().min.y, -4, single)
        << "to the right of the origin";
    EXPECT_THROW(segmentMarksOf(s.scan, s.result, s.map, 2, {}), std::out_of_range);
}

}  // namespace
}  // namespace offmap::view
