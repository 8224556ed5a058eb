// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "TurnsInPieces.h"

#include <offmap/rawlog/TurnReducer.h>
#include <offmap/rawlog/VelodyneScan.h>

#include <gtest/gtest.h>

#include <utility>

namespace offmap::rawlog {
namespace {

using core::MatchingMethod;

Config configOf(MatchingMethod method) {
    Config config;
    config.reduction.matching.method = method;
    return config;
}

/// A mask that takes out a tenth of the returns, and a table that tells those of a Velodyne apart.
Config maskedAndTabled() {
    Config config = configOf(MatchingMethod::Aligned);
    config.sensor.minRange = 1.5;
    config.sensor.robotBox = RobotBox{{-2, -2, -0.1}, {1, 1, 3}};
    config.sensor.rangeSigmaByIntensity = {0.05, 0.02, 0.15, 0.005};
    return config;
}

class TurnInPieces : public testing::Test {
 protected:
    ReducedTurn inPieces(TurnReducer& reducer, const test::VelodyneObservation::Ptr& whole,
                         uint32_t seed) const {
        reducer.begin(scanClass_);
        for (const size_t packets : test::randomPieces(whole->scan_packets.size(), seed)) {
            reducer.add(test::firstPackets(*whole, packets));
        }
        return reducer.finish({whole});
    }

    static void expectSame(const ReducedTurn& a, const core::ReductionResult& ofA,
                           const ReducedTurn& b, const core::ReductionResult& ofB) {
        EXPECT_EQ(a.removedSlots, b.removedSlots);
        EXPECT_EQ(a.organized.scan.points, b.organized.scan.points);
        EXPECT_EQ(a.organized.scan.sourceIndex, b.organized.scan.sourceIndex);
        EXPECT_EQ(a.organized.scan.rangeSigma, b.organized.scan.rangeSigma);
        EXPECT_EQ(a.returnsPerSegment, b.returnsPerSegment);
        EXPECT_EQ(a.removedPerSegment, b.removedPerSegment);
        EXPECT_EQ(ofA.labels, ofB.labels);
        EXPECT_EQ(test::bytesOf(*a.reduced.front()), test::bytesOf(*b.reduced.front()));
        forEachCount([](const char* key, auto x, auto y) { EXPECT_EQ(x, y) << key; }, a.record,
                     b.record);
        ASSERT_EQ(a.vehicleInMap.has_value(), b.vehicleInMap.has_value());
        if (!a.vehicleInMap) return;
        EXPECT_EQ(a.vehicleInMap->mean.asTPose(), b.vehicleInMap->mean.asTPose());
    }

    void expectAsWhole(const Config& config, const test::VelodyneObservation::Ptr& whole,
                       uint32_t seed) const {
        TurnReducer reducer(map_, poses_, config, OutputClass::Same);
        TurnReducer atOnce(map_, poses_, config, OutputClass::Same);
        const ReducedTurn pieces = inPieces(reducer, whole, seed);
        const ReducedTurn expected = atOnce.reduce({whole}, scanClass_);
        EXPECT_GT(expected.record.removed(), 0U);
        expectSame(pieces, reducer.result(), expected, atOnce.result());
    }

    const core::LineMap map_{mapOf(evaluation::officeRoom())};
    const test::DrivenVehicle poses_{test::turningPose};
    const VelodyneScan scanClass_;
};

TEST_F(TurnInPieces, isReducedAsTheWholeTurn) {
    for (const auto& whole : test::velodyneTurns()) {
        for (const auto method :
             {MatchingMethod::Paper, MatchingMethod::Probabilistic, MatchingMethod::Aligned}) {
            SCOPED_TRACE(testing::Message() << whole->sensorLabel << " " << int(method));
            expectAsWhole(configOf(method), whole, 7);
        }
    }
}

TEST_F(TurnInPieces, maskAndSigmasAreThoseOfTheWholeTurn) {
    const Config config = maskedAndTabled();
    for (const auto& whole : test::velodyneTurns()) {
        for (uint32_t seed = 1; seed <= 3; ++seed) {
            SCOPED_TRACE(testing::Message() << whole->sensorLabel << ", seed " << seed);
            expectAsWhole(config, whole, seed);
        }
    }
    TurnReducer reducer(map_, poses_, config, OutputClass::Same);
    const ReducedTurn reduced = inPieces(reducer, test::velodyneTurns()[1], 1);
    EXPECT_GT(reduced.record.counts.self, 1000U);
    EXPECT_GT(reduced.organized.duplicates.size(), 1000U) << "whose points are numbered anew";
    EXPECT_EQ(reduced.organized.scan.rangeSigma.size(), reduced.organized.scan.points.size());
}

TEST_F(TurnInPieces, aTurnThatIsNotFinishedLeavesNothingBehind) {
    const auto whole = test::velodyneTurns().front();
    TurnReducer reducer(map_, poses_, {}, OutputClass::Same);
    TurnReducer fresh(map_, poses_, {}, OutputClass::Same);
    reducer.begin(scanClass_);
    reducer.add(test::firstPackets(*test::velodyneTurns().back(), 40));
    reducer.begin(scanClass_);
    reducer.add(test::firstPackets(*test::velodyneTurns()[1], 40));
    const ReducedTurn after = reducer.reduce({whole}, scanClass_);
    const ReducedTurn expected = fresh.reduce({whole}, scanClass_);
    expectSame(after, reducer.result(), expected, fresh.result());
}

/// Poses that are corrected, and then all of them are others.
class CorrectedPoses : public test::DrivenVehicle {
 public:
    CorrectedPoses() : DrivenVehicle(test::turningPose) {}

    PoseLookup at(mrpt::Clock::time_point time) const override {
        PoseLookup lookup = DrivenVehicle::at(time);
        *lookup.vehicleInMap =
            mrpt::poses::CPose3D(0.01 * double(revision), 0, 0, 0, 0, 0) + *lookup.vehicleInMap;
        return lookup;
    }
    SettledPoses settled() const override { return {mrpt::Clock::time_point::max(), revision}; }

    uint64_t revision = 0;
};

TEST_F(TurnInPieces, posesThatAreCorrectedMeanwhileHoldForAllOfIt) {
    const auto whole = test::velodyneTurns().front();
    CorrectedPoses poses;
    TurnReducer reducer(map_, poses, {}, OutputClass::Same);
    reducer.begin(scanClass_);
    for (size_t packets = 10; packets <= 70; packets += 20) {
        reducer.add(test::firstPackets(*whole, packets));
        poses.revision = packets < 60 ? 1 : 2;  // after the first piece, and after the last one
    }
    const ReducedTurn pieces = reducer.finish({whole});
    TurnReducer atOnce(map_, poses, {}, OutputClass::Same);
    const ReducedTurn expected = atOnce.reduce({whole}, scanClass_);
    expectSame(pieces, reducer.result(), expected, atOnce.result());
    for (size_t c = 0; c < expected.organized.scan.columns.size(); ++c) {
        const auto& pose = pieces.organized.scan.columns[c].sensor->sensorInMap;
        EXPECT_EQ(pose.x(), expected.organized.scan.columns[c].sensor->sensorInMap.x()) << c;
    }
}

}  // namespace
}  // namespace offmap::rawlog
