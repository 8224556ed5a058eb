// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentWorld.h"

#include <offmap/core/OrphanRemoval.h>

#include <gtest/gtest.h>

namespace offmap::core {

namespace {

constexpr auto ray = Verdict::MappedByRay, kept = Verdict::Kept, orphan = Verdict::RemovedAsOrphan;

void removeIn(test::SegmentWorld& world) {
    const OrphanConfig config{.remove = true, .neighbourColumns = 2, .maxDistance = 0.5};
    SegmentsByColumn byColumn;
    byColumn.build(world.segments, world.viewpoints);
    removeOrphans(ColumnRing(world.scan), world.segments, byColumn, config, world.matches);
}

}  // namespace

TEST(OrphanRemoval, loneSegmentIsRemoved) {
    test::SegmentWorld world(360);
    const auto lone = world.add(100, 3, kept);
    removeIn(world);
    EXPECT_EQ(world.matches[lone].verdict, orphan);
    EXPECT_EQ(world.matches[lone].reason, KeepReason::None);
}

TEST(OrphanRemoval, companyIsKeptUpToItsDistanceInColumnsAndMetres) {
    struct Case {
        uint32_t columnsApart;
        double metresApart;
        Verdict verdict;
    };
    // At 3 m a column is 5 cm.
    for (const auto& [columns, metres, verdict] :
         {Case{1, 0, kept}, Case{2, 0, kept}, Case{3, 0, orphan}, Case{1, 0.49, kept},
          Case{1, 0.51, orphan}, Case{0, 0.4, kept}}) {
        test::SegmentWorld world(360);
        world.add(100, 3, kept);
        world.add(100 + columns, 3 + metres, kept);
        removeIn(world);
        EXPECT_EQ(world.matches[0].verdict, verdict) << columns << ", " << metres;
        EXPECT_EQ(world.matches[1].verdict, verdict) << columns << ", " << metres;
    }
}

TEST(OrphanRemoval, companyIsFoundAcrossTheEndOfTheTurn) {
    test::SegmentWorld world(360);
    world.add(0, 3, kept);
    world.add(359, 3, kept);
    removeIn(world);
    EXPECT_EQ(world.matches[0].verdict, kept);
    EXPECT_EQ(world.matches[1].verdict, kept);
}

TEST(OrphanRemoval, mappedNeighbourIsNoCompany) {
    test::SegmentWorld world(360);
    world.add(99, 3, ray);
    const auto lone = world.add(100, 3, kept);
    world.add(101, 3, ray);
    removeIn(world);
    EXPECT_EQ(world.matches[lone].verdict, orphan);
    EXPECT_EQ(world.matches[0].verdict, ray);
}

TEST(OrphanRemoval, segmentWithoutPoseStays) {
    test::SegmentWorld world(360);
    world.add(100, 3, kept);
    world.viewpoints[100].reset();
    world.matches[0] = SegmentMatch();  // Kept, NoPose
    removeIn(world);
    EXPECT_EQ(world.matches[0].verdict, kept);
    EXPECT_EQ(world.matches[0].reason, KeepReason::NoPose);
}

TEST(OrphanRemoval, besideAColumnWithoutPoseNothingIsCertainlyAlone) {
    test::SegmentWorld world(360);
    world.add(100, 3, kept);
    world.add(101, 3, kept);
    world.viewpoints[101].reset();
    world.matches[1] = SegmentMatch();  // Kept, NoPose: where it is in the map is not known
    removeIn(world);
    EXPECT_EQ(world.matches[0].verdict, kept);
}

}  // namespace offmap::core
