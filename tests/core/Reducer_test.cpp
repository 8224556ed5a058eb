// SPDX-License-Identifier: BSD-3-Clause
#include "SmallRoom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <vector>

namespace offmap::core {

using mrpt::poses::CPose3D;
using test::labelsOf;
using test::mappedSlabs;
using test::Slab;
using test::usualCovariance;
using Room = test::SmallRoom;

namespace {

size_t count(const std::vector<PointLabel>& labels, PointLabel label) {
    return static_cast<size_t>(std::count(labels.begin(), labels.end(), label));
}

}  // namespace

TEST(Reducer, mapsEveryWallReturnAndNoneOfWhatIsOffTheMap) {
    const Room room;
    const auto labels = labelsOf(room.map, room.built.scan);
    ASSERT_EQ(labels.size(), room.built.scan.points.size());
    for (size_t i = 0; i < labels.size(); ++i) {
        const int surface = room.built.surface[i];
        if (surface == test::floorSurface) continue;
        EXPECT_EQ(labels[i] == PointLabel::Mapped, surface < mappedSlabs) << "point " << i;
    }
}

TEST(Reducer, emptyMapReducesNothing) {
    const Room room;
    const LineMap none({});
    Reducer reducer(none, {});
    const ReductionResult& result = reducer.reduce(room.built.scan);
    EXPECT_EQ(result.notReduced, PoseFault::OffMap);
    EXPECT_EQ(result.columnsWithoutPose, 0u);
    EXPECT_EQ(count(result.labels, PointLabel::Mapped), 0u);
    EXPECT_GT(count(result.labels, PointLabel::Kept), 0u);
    for (const SegmentMatch& match : result.matches) {
        EXPECT_EQ(match.reason, KeepReason::NoWallOnRay);
    }
}

TEST(Reducer, robotThatComesIntoRangeOfAWallIsNotOffTheMap) {
    // A straight drive towards a wall; only from the last columns it is within 5 m.
    const LineMap map({{{{6, -9}, {6, 9}}, 0.02}});
    ReductionConfig config;
    config.matching.maxRange = 5;
    OrganizedScan scan;
    for (int c = 0; c < 8; ++c) {
        const Slab wall{{{6, -9}, {6, 9}}};
        const CPose3D sensor(0.5 + 0.1 * c, 0, 1, 0, 0, 0);
        const auto column = test::ScanBuilder({&wall, 1}, sensor)
                                .build({.columns = 1, .firstAzimuth = 0.001 * c})
                                .scan;
        scan.columns.push_back(column.columns[0]);
        scan.columns.back().begin += static_cast<uint32_t>(scan.points.size());
        scan.columns.back().end += static_cast<uint32_t>(scan.points.size());
        scan.points.insert(scan.points.end(), column.points.begin(), column.points.end());
    }
    Reducer reducer(map, config);
    const ReductionResult& result = reducer.reduce(scan);
    EXPECT_GT(count(result.labels, PointLabel::Mapped), 0u);
    EXPECT_FALSE(result.notReduced);
}

TEST(Reducer, columnsWithoutPoseAreKeptAndTheOthersReduced) {
    Room room;
    for (uint32_t c = 100; c < 140; ++c) {
        room.built.scan.columns[c].sensor.reset();
        room.built.scan.columns[c].fault = PoseFault::TooOld;
    }
    Reducer reducer(room.map, {});
    const ReductionResult& result = reducer.reduce(room.built.scan);
    EXPECT_FALSE(result.notReduced);
    EXPECT_EQ(result.columnsWithoutPose, 40u);
    size_t mapped = 0;
    for (size_t s = 0; s < result.segments.size(); ++s) {
        const bool blind = result.segments[s].column >= 100 && result.segments[s].column < 140;
        EXPECT_EQ(result.matches[s].reason == KeepReason::NoPose, blind);
        EXPECT_FALSE(blind && result.matches[s].mapped());
        mapped += result.matches[s].mapped();
    }
    EXPECT_GT(mapped, 250u);
}

TEST(Reducer, scanWithoutAnyPoseIsKeptForItsReason) {
    for (const PoseFault fault : {PoseFault::NoPose, PoseFault::TooOld, PoseFault::NotPsd}) {
        Room room;
        for (ScanColumn& column : room.built.scan.columns) {
            column.sensor.reset();
            column.fault = fault;
        }
        Reducer reducer(room.map, {});
        const ReductionResult& result = reducer.reduce(room.built.scan);
        EXPECT_EQ(result.notReduced, fault);
        EXPECT_EQ(result.columnsWithoutPose, 360u);
        EXPECT_EQ(count(result.labels, PointLabel::Mapped), 0u);
    }
}

TEST(Reducer, poseTooUncertainKeepsTheScan) {
    Room room;
    for (ScanColumn& column : room.built.scan.columns) {
        column.sensor->groundCovariance(0, 0) = 0.3 * 0.3;  // two sigmas: 0.6 m of at most 0.5 m
    }
    ReductionConfig config;
    config.matching.method = MatchingMethod::Paper;
    config.matching.sigmaFactor = 2;
    config.matching.maxPositionRadius = 0.5;
    Reducer reducer(room.map, config);
    EXPECT_EQ(reducer.reduce(room.built.scan).notReduced, PoseFault::TooUncertain);
    EXPECT_EQ(count(reducer.reduce(room.built.scan).labels, PointLabel::Mapped), 0u);
}

TEST(Reducer, emptyScanHasNothingToReduce) {
    const Room room;
    Reducer reducer(room.map, {});
    EXPECT_FALSE(reducer.reduce({}).notReduced);
    OrganizedScan emptyColumns = room.built.scan;
    emptyColumns.points.clear();
    for (ScanColumn& column : emptyColumns.columns) column.begin = column.end = 0;
    const ReductionResult& result = reducer.reduce(emptyColumns);
    EXPECT_FALSE(result.notReduced);
    EXPECT_TRUE(result.labels.empty());
    EXPECT_TRUE(result.segments.empty());
    EXPECT_EQ(result.columnsWithoutPose, 0u);
}

TEST(Reducer, onePointColumnsAreKept) {
    const Room room;
    OrganizedScan scan = room.built.scan;
    for (ScanColumn& column : scan.columns) column.end = column.begin + 1;
    const auto labels = labelsOf(room.map, scan);
    EXPECT_EQ(count(labels, PointLabel::NotOnVerticalSegment), labels.size());
}

TEST(Reducer, resultDoesNotDependOnTheScanBefore) {
    const Room room;
    Reducer reducer(room.map, {});
    const auto expected = reducer.reduce(room.built.scan).labels;
    const std::vector<Slab> other{{{{3, -2}, {3, 2}}}};
    reducer.reduce(test::ScanBuilder(other, room.sensor).build({.columns = 700}).scan);
    EXPECT_EQ(reducer.reduce(room.built.scan).labels, expected);
}

TEST(Reducer, labelsSayWhatTheMatchesSay) {
    const Room room;
    ReductionConfig config;
    config.orphan.remove = true;
    Reducer reducer(room.map, config);
    const ReductionResult& result = reducer.reduce(room.built.scan);
    ASSERT_EQ(result.matches.size(), result.segments.size());
    std::vector<PointLabel> expected(room.built.scan.points.size(),
                                     PointLabel::NotOnVerticalSegment);
    for (size_t s = 0; s < result.segments.size(); ++s) {
        const SegmentMatch& match = result.matches[s];
        for (uint32_t i = result.segments[s].begin; i < result.segments[s].end; ++i) {
            expected[i] = match.mapped()                              ? PointLabel::Mapped
                          : match.verdict == Verdict::RemovedAsOrphan ? PointLabel::Orphan
                                                                      : PointLabel::Kept;
        }
        EXPECT_EQ(match.verdict == Verdict::Kept, match.reason != KeepReason::None);
    }
    EXPECT_EQ(result.labels, expected);
}

TEST(Reducer, orphansGoOnlyWhenAskedFor) {
    // A post so thin that one column alone meets it.
    std::vector<Slab> slabs = test::boxRoom(8, 6);
    slabs.push_back({{{1, -0.01}, {1, 0.01}}, 0, 2});
    const auto built =
        test::ScanBuilder(slabs, CPose3D(0, 0, 1.1, 0, 0, 0)).build({}, usualCovariance());
    const LineMap map(test::wallsOf(std::span(slabs).first(mappedSlabs)));
    ReductionConfig config;
    EXPECT_EQ(count(labelsOf(map, built.scan, config), PointLabel::Orphan), 0u);
    EXPECT_GT(count(labelsOf(map, built.scan, config), PointLabel::Kept), 0u);
    config.orphan.remove = true;
    EXPECT_GT(count(labelsOf(map, built.scan, config), PointLabel::Orphan), 0u);
    EXPECT_EQ(count(labelsOf(map, built.scan, config), PointLabel::Kept), 0u);
}

TEST(Reducer, configurationThatIsNotValidThrows) {
    const LineMap map({});
    ReductionConfig config;
    config.vertical.maxTilt = 2;
    EXPECT_THROW(Reducer(map, config), std::invalid_argument);
}

}  // namespace offmap::core
