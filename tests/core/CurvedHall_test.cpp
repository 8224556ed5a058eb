// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ScanBuilder.h"

#include <offmap/core/ArcWalls.h>
#include <offmap/core/Reducer.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <numbers>

namespace offmap::core {

using mrpt::math::TPoint2D;
using mrpt::poses::CPose3D;

namespace {

constexpr double pi = std::numbers::pi;
constexpr CircularArc apse{{0, 0}, 5, -0.75 * pi, 1.5 * pi};
constexpr double sigma = 0.01;  // [m] of the map

std::vector<mrpt::math::TSegment2D> chordsOf(const CircularArc& arc, int count) {
    const auto at = [&](int i) {
        const double angle = arc.start + arc.sweep * i / count;
        return arc.centre + TPoint2D(std::cos(angle), std::sin(angle)) * arc.radius;
    };
    std::vector<mrpt::math::TSegment2D> chords;
    for (int i = 0; i < count; ++i) chords.emplace_back(at(i), at(i + 1));
    return chords;
}

/// Three quarters of a round hall, closed by a straight wall; a box stands 0.4 m before the round
/// one. Chords of 1 degree stray from the circle by 0.2 mm.
struct Hall {
    static constexpr int chords = 270;

    Hall() {
        std::vector<test::Slab> slabs;
        for (const auto& chord : chordsOf(apse, chords)) slabs.push_back({chord});
        slabs.push_back({straightWall()});
        slabs.push_back({{{4.4, -0.3}, {4.4, 0.3}}, 0, 1.2});
        const Eigen::Matrix3d covariance =
            Eigen::Vector3d(0.05 * 0.05, 0.05 * 0.05, 0.02 * 0.02).asDiagonal();
        built = test::ScanBuilder(slabs, truth).build({.columns = 240, .rows = 91}, covariance);
        for (ScanColumn& column : built.scan.columns) column.sensor->sensorInMap = stated;
    }

    static mrpt::math::TSegment2D straightWall() {
        const auto chords1 = chordsOf(apse, 1);
        return {chords1[0].point2, chords1[0].point1};
    }

    struct Outcome {
        double wallRemoved, boxRemoved;  // shares
        Vector5 correction;
    };
    Outcome reducedWith(std::vector<Wall> walls, MatchingMethod method) const {
        walls.push_back({straightWall(), sigma});
        ReductionConfig config;
        config.matching.method = method;
        const LineMap map(std::move(walls));
        Reducer reducer(map, config);
        const ReductionResult& result = reducer.reduce(built.scan);
        double round = 0, roundRemoved = 0, box = 0, boxRemoved = 0;
        for (size_t i = 0; i < built.surface.size(); ++i) {
            const bool removed = result.labels[i] == PointLabel::Mapped;
            if (built.surface[i] == chords + 1) {
                ++box;
                boxRemoved += removed;
            } else if (built.surface[i] >= 0 && built.surface[i] < chords) {
                ++round;
                roundRemoved += removed;
            }
        }
        return {roundRemoved / round, boxRemoved / box,
                result.alignment ? result.alignment->correction.mean : Vector5::Zero()};
    }

    const CPose3D truth{-0.8, 0.5, 1.1, 0.3, 0, 0};
    const CPose3D stated{-0.76, 0.45, 1.1, 0.32, 0, 0};
    test::BuiltScan built;
};

std::vector<Wall> byChords(int count) {
    std::vector<Wall> walls;
    for (const auto& chord : chordsOf(apse, count)) walls.push_back({chord, sigma});
    return walls;
}

std::vector<Wall> byArcs() { return wallsAlong(apse, {{}, sigma}); }

}  // namespace

// Without noise, nothing but the map's form stands between the scan and its wall. `probabilistic`,
// which leaves the pose's error in, may take a few returns at the wall's foot for the floor's: one
// in a hundred of the 91 rows at most.
TEST(CurvedHall, arcsRemoveTheRoundWallWithEveryMethod) {
    const Hall hall;
    for (const auto method :
         {MatchingMethod::Paper, MatchingMethod::Probabilistic, MatchingMethod::Aligned}) {
        const Hall::Outcome outcome = hall.reducedWith(byArcs(), method);
        EXPECT_GT(outcome.wallRemoved, 0.99) << static_cast<int>(method);
        EXPECT_EQ(outcome.boxRemoved, 0);
    }
}

// The scan's pose is off by -4 cm, 5 cm and 0.02 rad. Chords of 15 degrees stray by 4.3 cm from the
// circle, all to its inside.
TEST(CurvedHall, alignsToArcsBetterThanToChords) {
    const Hall hall;
    const auto byArc = hall.reducedWith(byArcs(), MatchingMethod::Aligned);
    const auto byChord = hall.reducedWith(byChords(18), MatchingMethod::Aligned);
    EXPECT_NEAR(byArc.correction[0], -0.04, 0.002);
    EXPECT_NEAR(byArc.correction[1], 0.05, 0.002);
    EXPECT_NEAR(byArc.correction[2], -0.02, 0.001);
    EXPECT_GT(std::abs(byChord.correction[0] + 0.04), 0.01);
    EXPECT_LT(byChord.wallRemoved, 0.9);
}

// 30 degrees: 17 cm.
TEST(CurvedHall, coarserChordsLoseMoreOfTheWall) {
    const Hall hall;
    double last = 1;
    for (const int chords : {27, 18, 9}) {
        const double removed =
            hall.reducedWith(byChords(chords), MatchingMethod::Aligned).wallRemoved;
        EXPECT_LE(removed, last) << chords;
        last = removed;
    }
    EXPECT_LT(last, 0.3);
}

}  // namespace offmap::core
