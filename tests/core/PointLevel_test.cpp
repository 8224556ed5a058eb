// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/PointLevel.h>

#include <gtest/gtest.h>

#include <vector>

namespace offmap::core {

namespace {

/// Columns a degree apart, each looking along its own azimuth at a wall 3 m ahead, x = 3: returns
/// every 10 cm from 1 m below the sensor to 1 m above it, at the distances before the wall that the
/// test says.
struct AtTheWall {
    static constexpr uint32_t columns = 9, returns = 21;

    AtTheWall() {
        for (uint32_t c = 0; c < columns; ++c) {
            ScanColumn column;
            column.begin = c * returns;
            column.end = column.begin + returns;
            column.azimuth = 0.0175F * static_cast<float>(c);
            column.sensor = SensorPose{};
            scan.columns.push_back(column);
            for (uint32_t i = 0; i < returns; ++i) {
                const double x = 3, y = 0.05 * c, z = -1 + 0.1 * i;
                scan.points.emplace_back(x, y, z);
                scan.sourceIndex.push_back(column.begin + i);
            }
        }
        correction.covariance.diagonal().setConstant(1e-8);
        labels.assign(scan.points.size(), PointLabel::NotOnVerticalSegment);
    }

    void moveForward(uint32_t column, uint32_t first, uint32_t last, float distance) {
        for (uint32_t i = first; i <= last; ++i) scan.points[column * returns + i].x -= distance;
    }

    /// The returns first ... last of a column as a segment that was removed with the wall.
    void removeSegment(uint32_t column, uint32_t first, uint32_t last) {
        VerticalSegment segment{};
        segment.column = column;
        segment.begin = column * returns + first;
        segment.end = column * returns + last + 1;
        segment.centre = {3, 0.05 * column};
        segment.bottom = {3, -1 + 0.1 * first};
        segment.top = {3, -1 + 0.1 * last};
        segments.push_back(segment);
        SegmentMatch match;
        match.verdict = Verdict::MappedByRay;
        match.wall = 0;
        matches.push_back(match);
        for (uint32_t i = segment.begin; i < segment.end; ++i) labels[i] = PointLabel::Mapped;
    }

    ReturnOffsets offsets() {
        level(scan, levelled);
        places.clear();
        addPlaces(scan, places);
        return {scan, levelled, places, correction, map, config};
    }

    PointLabel label(uint32_t column, uint32_t i) const { return labels[column * returns + i]; }

    OrganizedScan scan;
    LevelledScan levelled;
    std::vector<ColumnPlace> places;
    PoseCorrection correction;
    LineMap map{{{.line = {{3, -5}, {3, 5}}, .sigma = 0.01}}};
    AlignmentConfig config{.sigmaRange = 0.02};
    std::vector<VerticalSegment> segments;
    std::vector<SegmentMatch> matches;
    LooseReturnsScratch scratch;
    std::vector<PointLabel> labels;
};

constexpr auto mapped = PointLabel::Mapped, kept = PointLabel::Kept,
               loose = PointLabel::NotOnVerticalSegment;

}  // namespace

TEST(LooseReturns, onAWallThatWasRemovedBesideGoToo) {
    AtTheWall scene;
    scene.removeSegment(3, 0, 20);
    labelLooseReturns(scene.offsets(), scene.segments, scene.matches, scene.scratch, scene.labels);
    EXPECT_EQ(scene.label(4, 10), mapped);
    EXPECT_EQ(scene.label(6, 10), mapped);
    EXPECT_EQ(scene.label(7, 10), loose) << "four columns away";
}

TEST(LooseReturns, stayOutsideTheHeightsThatWereRemoved) {
    AtTheWall scene;
    scene.removeSegment(3, 5, 15);  // z from -0.5 to 0.5 m
    labelLooseReturns(scene.offsets(), scene.segments, scene.matches, scene.scratch, scene.labels);
    EXPECT_EQ(scene.label(4, 5), loose) << "its foot: it may be of the floor";
    EXPECT_EQ(scene.label(4, 6), mapped);
    EXPECT_EQ(scene.label(4, 14), mapped);
    EXPECT_EQ(scene.label(4, 15), loose);
    EXPECT_EQ(scene.label(3, 18), loose);
}

// The gate: 3 sigma of hypot(0.02, 0.01) m = 6.7 cm.
TEST(LooseReturns, stayBeforeTheWall) {
    AtTheWall scene;
    scene.removeSegment(3, 0, 20);
    scene.moveForward(4, 0, 9, 0.06F);
    scene.moveForward(4, 10, 20, 0.08F);
    labelLooseReturns(scene.offsets(), scene.segments, scene.matches, scene.scratch, scene.labels);
    EXPECT_EQ(scene.label(4, 5), mapped);
    EXPECT_EQ(scene.label(4, 15), loose);
}

TEST(LooseReturns, labelsOfSegmentsAreNotTouched) {
    AtTheWall scene;
    scene.removeSegment(3, 0, 20);
    for (uint32_t i = 0; i < AtTheWall::returns; ++i) {
        scene.labels[4 * AtTheWall::returns + i] = kept;
    }
    labelLooseReturns(scene.offsets(), scene.segments, scene.matches, scene.scratch, scene.labels);
    EXPECT_EQ(scene.label(4, 10), kept);
}

// Eight returns 8 cm before the wall: their mean is off by chance by 3 * hypot(0.01, 0.02 /
// sqrt(8))
// + 0.02 m = 5.7 cm at most.
TEST(RunsOffTheWall, standingBeforeItStay) {
    AtTheWall scene;
    scene.removeSegment(3, 0, 20);
    scene.moveForward(3, 6, 13, 0.08F);
    keepRunsOffTheWall(scene.offsets(), scene.segments, scene.matches, scene.labels);
    for (uint32_t i = 6; i <= 13; ++i) EXPECT_EQ(scene.label(3, i), kept) << i;
}

TEST(RunsOffTheWall, ofNoiseOrOfFewReturnsDoNotCount) {
    AtTheWall scene;
    scene.removeSegment(3, 0, 20);
    for (uint32_t i = 0; i <= 20; ++i) scene.moveForward(3, i, i, i % 2 == 0 ? 0.04F : -0.04F);
    scene.removeSegment(5, 0, 20);
    for (uint32_t i = 0; i <= 20; ++i) scene.moveForward(5, i, i, -0.01F);
    scene.moveForward(5, 8, 10, 0.3F);  // three returns
    keepRunsOffTheWall(scene.offsets(), scene.segments, scene.matches, scene.labels);
    for (uint32_t i = 0; i <= 20; ++i) {
        EXPECT_EQ(scene.label(3, i), mapped) << i;
        EXPECT_EQ(scene.label(5, i), mapped) << i;
    }
}

// The floor 1 m below: a return 2.5 m away, the next 2.95 m away, 5 cm before the wall; then 3 cm
// before it, then the wall.
TEST(FloorAtTheFoot, staysWhereTheReturnBesideItIsAsHigh) {
    AtTheWall scene;
    scene.moveForward(3, 0, 0, 0.5F);
    scene.moveForward(3, 1, 1, 0.05F);
    scene.moveForward(3, 2, 2, 0.03F);
    for (const uint32_t i : {1U, 2U}) scene.scan.points[3 * AtTheWall::returns + i].z = -1;
    scene.removeSegment(3, 1, 20);
    keepFloorAtTheFoot(scene.offsets(), scene.segments, scene.matches, scene.labels);
    EXPECT_EQ(scene.label(3, 1), kept);
    EXPECT_EQ(scene.label(3, 2), kept);
    for (uint32_t i = 3; i <= 20; ++i) EXPECT_EQ(scene.label(3, i), mapped) << i;
}

TEST(FloorAtTheFoot, isToldFromAWallThatEndsHigher) {
    AtTheWall scene;
    scene.moveForward(3, 0, 0, 0.5F);
    scene.moveForward(3, 1, 1, 0.05F);  // 10 cm above the return beside it
    scene.removeSegment(3, 1, 20);
    scene.moveForward(5, 20, 20, 0.5F);  // a beam of light, say, before the wall's top
    scene.moveForward(5, 19, 19, -0.05F);
    scene.scan.points[5 * AtTheWall::returns + 20].z = 0.9F;
    scene.removeSegment(5, 0, 19);  // and its last return is behind the wall's line
    keepFloorAtTheFoot(scene.offsets(), scene.segments, scene.matches, scene.labels);
    EXPECT_EQ(scene.label(3, 1), mapped);
    EXPECT_EQ(scene.label(5, 19), mapped);
}

}  // namespace offmap::core
