// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SweepMaker.h"

#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/TurnReducer.h>

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <cmath>
#include <numeric>

namespace offmap::rawlog {
namespace {

using Cloud = mrpt::obs::CObservationPointCloud;
using mrpt::poses::CPose3D;

/// The walls of test::room(): 10 x 10 m around the origin.
core::LineMap roomMap() {
    const mrpt::math::TPoint2D a(-5, -5), b(5, -5), c(5, 5), d(-5, 5);
    return core::LineMap({{{a, b}}, {{b, c}}, {{c, d}}, {{d, a}}});
}

Turn roomTurn(std::chrono::milliseconds betweenColumns = std::chrono::milliseconds(10)) {
    Turn turn;
    for (int c = 0; c < 180; ++c) {
        turn.push_back(
            test::fanIn(test::room(), test::fanPose(2.0 * c), {.time = c * betweenColumns}));
    }
    return turn;
}

Turn cloudOfRoom() {
    auto cloud = std::make_shared<Cloud>();
    cloud->sensorPose = CPose3D(0, 0, 1, 0, 0, 0);
    cloud->pointcloud = mrpt::maps::CSimplePointsMap::Create();
    for (const auto& obs : roomTurn()) {
        const auto& fan = dynamic_cast<const test::Fan&>(*obs);
        for (size_t i = 0; i < fan.getScanSize(); ++i) {
            const auto p =
                fan.sensorPose.composePoint(test::rayDirection(fan, i) * fan.getScanRange(i));
            cloud->pointcloud->insertPoint(static_cast<float>(p.x), static_cast<float>(p.y),
                                           static_cast<float>(p.z - 1));
        }
    }
    return {cloud};
}

uint64_t sumOf(const std::vector<uint8_t>& slots) {
    return std::accumulate(slots.begin(), slots.end(), uint64_t{0});
}

TEST(TurnReducer, recordCountsWhatTheSlotsSay) {
    const core::LineMap map = roomMap();
    const test::DrivenVehicle poses{CPose3D()};
    for (const Turn& turn : {roomTurn(), cloudOfRoom()}) {
        TurnReducer reducer(map, poses, {}, OutputClass::Same);
        const ReducedTurn reduced = reducer.reduce(turn, *scanClassOf(*turn.front(), {}));
        EXPECT_GT(reduced.record.removed(), 0U);
        EXPECT_EQ(reduced.record.removed(), sumOf(reduced.removedSlots));
        EXPECT_LE(reduced.record.removed(), reduced.record.onVerticalSegments);
        EXPECT_LT(reduced.record.onVerticalSegments, reduced.record.counts.returns);
        EXPECT_EQ(reduced.record.columns, 180U);
        EXPECT_TRUE(reduced.record.notReduced.empty());
    }
}

TEST(TurnReducer, repeatedReturnsShareTheFateOfTheFirst) {
    const core::LineMap map = roomMap();
    const test::DrivenVehicle poses{CPose3D()};
    TurnReducer reducer(map, poses, {}, OutputClass::Same);
    const Turn once = cloudOfRoom();
    const size_t points = dynamic_cast<const Cloud&>(*once.front()).pointcloud->size();

    auto doubled = std::make_shared<Cloud>(dynamic_cast<const Cloud&>(*once.front()));
    doubled->pointcloud = mrpt::maps::CSimplePointsMap::Create();
    for (int copy = 0; copy < 2; ++copy) {
        doubled->pointcloud->insertAnotherMap(
            dynamic_cast<const Cloud&>(*once.front()).pointcloud.get(), CPose3D());
    }
    ASSERT_EQ(doubled->pointcloud->size(), 2 * points);

    const ReducedTurn single = reducer.reduce(once, *scanClassOf(*once.front(), {}));
    const ReducedTurn both = reducer.reduce({doubled}, *scanClassOf(*doubled, {}));
    EXPECT_EQ(both.record.counts.duplicates, points);
    EXPECT_EQ(both.record.removed(), 2 * single.record.removed());
    EXPECT_EQ(both.record.onVerticalSegments, 2 * single.record.onVerticalSegments);
    for (size_t i = 0; i < points; ++i) {
        ASSERT_EQ(both.removedSlots[i], single.removedSlots[i]) << i;
        ASSERT_EQ(both.removedSlots[i + points], single.removedSlots[i]) << i;
    }
}

TEST(TurnReducer, turnWithoutPoseStaysAsItIs) {
    const core::LineMap map = roomMap();
    struct Nowhere : PoseSource {
        PoseLookup at(mrpt::Clock::time_point) const override { return {}; }
    };
    const Nowhere poses;
    TurnReducer reducer(map, poses, {}, OutputClass::Same);
    const Turn turn = roomTurn();
    const ReducedTurn reduced = reducer.reduce(turn, *scanClassOf(*turn.front(), {}));
    EXPECT_EQ(reduced.record.notReduced, "no_pose");
    EXPECT_EQ(reduced.record.columnsWithoutPose, 180U);
    EXPECT_EQ(sumOf(reduced.removedSlots), 0U);
    for (const auto& obs : reduced.reduced) EXPECT_EQ(obs, nullptr);
}

TEST(TurnReducer, movementIsAppliedColumnByColumn) {
    // The vehicle drives 2 m along x while the scanner turns. Its columns are placed where they
    // were taken or, wrongly, where the turn began; only then the walls across the way are missed.
    const core::LineMap map = roomMap();
    const auto start = mrpt::Clock::fromDouble(1.7e9);
    const auto path = [&](mrpt::Clock::time_point time) {
        return CPose3D(std::chrono::duration<double>(time - start).count() / 1.8 * 2 - 1, 0, 0, 0,
                       0, 0);
    };
    Turn turn;
    for (int c = 0; c < 180; ++c) {
        const std::chrono::milliseconds time(10 * c);
        const CPose3D sensorInMap = path(start + time) + test::fanPose(2.0 * c);
        const auto fan = test::fanIn(test::room(), sensorInMap, {.time = time});
        fan->sensorPose = test::fanPose(2.0 * c);
        turn.push_back(fan);
    }
    const test::DrivenVehicle poses(path);
    Config byColumn, byTurn;
    byColumn.sensor.poseReference = PoseReference::Column;
    byTurn.sensor.poseReference = PoseReference::Turn;
    const auto removedWith = [&](const Config& config) {
        return TurnReducer(map, poses, config, OutputClass::Same)
            .reduce(turn, *scanClassOf(*turn.front(), {}))
            .record.removed();
    };
    Config asPosesSuggest;  // x, y of sensorPose do not vary: Column
    EXPECT_EQ(removedWith(asPosesSuggest), removedWith(byColumn));
    EXPECT_LT(removedWith(byTurn), removedWith(byColumn) * 8 / 10);
}

}  // namespace
}  // namespace offmap::rawlog
