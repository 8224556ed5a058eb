// SPDX-License-Identifier: BSD-3-Clause
#include "SmallRoom.h"

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>

namespace offmap::core {

using mrpt::poses::CPose3D;

namespace {

/// The small room, its columns' pose shifted and turned against the truth.
test::SmallRoom roomSeenFrom(const CPose3D& error, double sigmaPosition, double sigmaHeadingDeg) {
    test::SmallRoom room;
    const double heading = mrpt::DEG2RAD(sigmaHeadingDeg);
    for (ScanColumn& column : room.built.scan.columns) {
        column.sensor->sensorInMap =
            CPose3D(room.sensor.x() + error.x(), room.sensor.y() + error.y(), room.sensor.z(),
                    room.sensor.yaw() + error.yaw(), 0, 0);
        column.sensor->groundCovariance =
            Eigen::Vector3d(sigmaPosition * sigmaPosition, sigmaPosition * sigmaPosition,
                            heading * heading)
                .asDiagonal();
    }
    return room;
}

struct Outcome {
    double mappedRemoved, unmappedRemoved;  // shares
};

/// Of returns on vertical segments that lie on slabs of the map; and of all that lie on no wall.
Outcome outcomeOf(const test::SmallRoom& room, const ReductionResult& result) {
    std::vector<uint8_t> onSegment(result.labels.size(), 0);
    for (const VerticalSegment& segment : result.segments) {
        std::fill(onSegment.begin() + segment.begin, onSegment.begin() + segment.end, uint8_t{1});
    }
    double mapped = 0, mappedRemoved = 0, unmapped = 0, unmappedRemoved = 0;
    for (size_t i = 0; i < result.labels.size(); ++i) {
        const int surface = room.built.surface[i];
        const bool removed = result.labels[i] == PointLabel::Mapped;
        if (surface >= 0 && surface < test::mappedSlabs) {
            if (!onSegment[i]) continue;
            ++mapped;
            mappedRemoved += removed;
        } else {
            ++unmapped;
            unmappedRemoved += removed;
        }
    }
    return {mappedRemoved / mapped, unmappedRemoved / unmapped};
}

ReductionConfig withMethod(MatchingMethod method) {
    ReductionConfig config;
    config.matching.method = method;
    return config;
}

}  // namespace

// Feet of walls take a return or two from the floor, half a percent of what is not on the map.
TEST(ReducerAligned, removesWallsWhateverThePosesErrorWithinItsCovariance) {
    for (const CPose3D& error : {CPose3D(), CPose3D(0.1, -0.05, 0, 0.01, 0, 0),
                                 CPose3D(-0.05, 0.1, 0, mrpt::DEG2RAD(5.0), 0, 0)}) {
        const auto room = roomSeenFrom(error, 0.08, 4);
        Reducer reducer(room.map, withMethod(MatchingMethod::Aligned));
        const ReductionResult& result = reducer.reduce(room.built.scan);
        EXPECT_FALSE(result.notReduced);
        const Outcome outcome = outcomeOf(room, result);
        EXPECT_GT(outcome.mappedRemoved, 0.995) << error.asString();
        EXPECT_LT(outcome.unmappedRemoved, 0.005) << error.asString();
    }
}

// 8 degrees move a wall 3 m away by 0.4 m, further than any gate reaches.
TEST(ReducerAligned, beatsTheGateOfThePriorAlone) {
    const auto room = roomSeenFrom(CPose3D(0.05, -0.05, 0, mrpt::DEG2RAD(8.0), 0, 0), 0.05, 4);
    Reducer aligned(room.map, withMethod(MatchingMethod::Aligned));
    Reducer probabilistic(room.map, withMethod(MatchingMethod::Probabilistic));
    const double withAlignment = outcomeOf(room, aligned.reduce(room.built.scan)).mappedRemoved;
    const double without = outcomeOf(room, probabilistic.reduce(room.built.scan)).mappedRemoved;
    EXPECT_GT(withAlignment, without);
    EXPECT_FALSE(probabilistic.reduce(room.built.scan).alignment);
}

TEST(ReducerAligned, keepsTheScanWholeThatFitsNowhere) {
    const auto room = roomSeenFrom(CPose3D(2.5, 1.5, 0, 1, 0, 0), 0.03, 0.5);
    Reducer reducer(room.map, withMethod(MatchingMethod::Aligned));
    const ReductionResult& result = reducer.reduce(room.built.scan);
    EXPECT_EQ(result.notReduced, PoseFault::DoesNotFit);
    EXPECT_EQ(std::ranges::count(result.labels, PointLabel::Mapped), 0);
    ASSERT_TRUE(result.alignment);
    EXPECT_LT(result.alignment->fittedShare, 0.3);
}

TEST(ReducerAligned, forgetsTheScanBefore) {
    const auto good = roomSeenFrom(CPose3D(), 0.05, 1);
    const auto lost = roomSeenFrom(CPose3D(2.5, 1.5, 0, 1, 0, 0), 0.03, 0.5);
    Reducer reducer(good.map, withMethod(MatchingMethod::Aligned));
    const auto first = reducer.reduce(good.built.scan).labels;
    reducer.reduce(lost.built.scan);
    EXPECT_EQ(reducer.reduce(good.built.scan).labels, first);
    EXPECT_FALSE(reducer.reduce(good.built.scan).notReduced);
}

}  // namespace offmap::core
