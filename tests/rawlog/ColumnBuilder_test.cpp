// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ColumnBuilder.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace offmap::rawlog {
namespace {

using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

TEST(ColumnBuilder, uprightMountingTurnsAzimuthsAsOneThatHardlyLeans) {
    for (const double yaw : {0.0, 1.0, 3.0, -3.0}) {
        for (double azimuth = -3.1; azimuth < 3.2; azimuth += 0.3) {
            const double upright = azimuthInVehicle(azimuth, CPose3D(1, 2, 3, yaw, 0, 0));
            const double leaning = azimuthInVehicle(azimuth, CPose3D(1, 2, 3, yaw, 1e-7, 1e-7));
            EXPECT_GE(upright, -M_PI);
            EXPECT_LE(upright, M_PI);
            // A lean of 1e-7 rad turns an azimuth by its square.
            EXPECT_NEAR(mrpt::math::wrapToPi(upright - leaning), 0, 1e-13);
        }
    }
}

TEST(ColumnBuilder, mountingUpsideDownMirrorsAzimuths) {
    EXPECT_NEAR(azimuthInVehicle(0.5, CPose3D(0, 0, 0, 0, 0, M_PI)), -0.5, 1e-12);
}

/// Returns some degrees above each other, at ranges of their own.
std::vector<TPoint3Df> upwardReturns(size_t count, const CPose3D& sensorInVehicle,
                                     double step_deg = 1) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> range(1, 40);
    std::vector<TPoint3Df> points;
    for (size_t i = 0; i < count; ++i) {
        const double r = range(random), elevation = mrpt::DEG2RAD(step_deg * double(i) - 30.0);
        const mrpt::math::TVector3D inVehicle(r * std::cos(elevation), 0, r * std::sin(elevation));
        points.emplace_back(TPoint3Df(sensorInVehicle.inverseRotateVector(inVehicle)));
    }
    return points;
}

/// A column as appendColumn() makes it, and as appendColumnInOrder() does if it does.
struct BothWays {
    BothWays(const std::vector<TPoint3Df>& points, const CPose3D& sensorInVehicle) {
        std::vector<ColumnReturn> returns;
        for (uint32_t i = 0; i < points.size(); ++i) returns.push_back({points[i], 100 + i});
        appendColumn(sorted, {}, sensorInVehicle, returns);
        const CloudArrays arrays(points);
        const PointSlots slots{.first = 100, .listed = {}};
        taken = appendColumnInOrder(asItStands, {}, sensorInVehicle, arrays.points(), slots, 0,
                                    static_cast<uint32_t>(points.size()));
    }
    void expectTheSame() const {
        ASSERT_TRUE(taken);
        EXPECT_EQ(asItStands.scan.points, sorted.scan.points);
        EXPECT_EQ(asItStands.scan.sourceIndex, sorted.scan.sourceIndex);
        ASSERT_EQ(asItStands.scan.columns.size(), 1U);
        EXPECT_EQ(asItStands.scan.columns[0].begin, sorted.scan.columns[0].begin);
        EXPECT_EQ(asItStands.scan.columns[0].end, sorted.scan.columns[0].end);
    }
    void expectNothingDone() const {
        EXPECT_FALSE(taken);
        EXPECT_TRUE(asItStands.scan.points.empty());
        EXPECT_TRUE(asItStands.scan.sourceIndex.empty());
        EXPECT_TRUE(asItStands.scan.columns.empty());
    }
    TurnScan sorted, asItStands;
    bool taken = false;
};

TEST(ColumnBuilder, columnsThatStandInOrderNeedNoSorting) {
    for (const CPose3D& mounting : {CPose3D(), CPose3D(0, 0, 1, 0.5, 0.1, -0.2)}) {
        for (size_t count = 1; count < 40; ++count) {
            SCOPED_TRACE(count);
            const auto points = upwardReturns(count, mounting);
            const BothWays upward(points, mounting);
            upward.expectTheSame();
            EXPECT_EQ(upward.sorted.scan.points, points);
            const BothWays downward({points.rbegin(), points.rend()}, mounting);
            downward.expectTheSame();
            EXPECT_EQ(downward.sorted.scan.points, points);
            EXPECT_EQ(downward.sorted.scan.sourceIndex.front(), 99 + count);
        }
    }
}

TEST(ColumnBuilder, aSingleReturnOutOfOrderIsNoticedWhereverItStands) {
    for (size_t count = 3; count < 30; ++count) {
        for (size_t i = 0; i + 1 < count; ++i) {
            SCOPED_TRACE(testing::Message() << i << " of " << count);
            auto points = upwardReturns(count, {});
            std::swap(points[i], points[i + 1]);
            BothWays(points, {}).expectNothingDone();
            points[i + 1] = points[i];  // and one that repeats the one below
            BothWays(points, {}).expectNothingDone();
        }
    }
}

TEST(ColumnBuilder, longColumnsAreLookedThroughToTheirEnd) {
    const auto inOrder = upwardReturns(1000, {}, 0.09);
    BothWays(inOrder, {}).expectTheSame();
    for (const size_t i : {0, 254, 255, 256, 509, 510, 511, 998}) {
        SCOPED_TRACE(i);
        auto points = inOrder;
        std::swap(points[i], points[i + 1]);
        const BothWays both(points, {});
        both.expectNothingDone();
        EXPECT_EQ(both.sorted.scan.points, inOrder);
    }
}

TEST(ColumnBuilder, returnsThatAreHardlyAboveEachOtherAreSortedExactly) {
    // 1e-7 rad above each other: too little to be told quickly, enough to be told.
    for (const float above : {1e-6F, -1e-6F}) {
        const std::vector<TPoint3Df> points{{10, 0, 0}, {10, 0, above}, {10, 0, 1}};
        const BothWays both(points, {});
        both.expectNothingDone();
        EXPECT_EQ(both.sorted.scan.points[above > 0 ? 0 : 1], points[0]);
        EXPECT_EQ(both.sorted.scan.points[above > 0 ? 1 : 0], points[1]);
    }
}

TEST(ColumnBuilder, rangesThatFloatsCannotSquareAreSortedAsOthers) {
    for (const float far : {1e25F, 1e-25F}) {
        const std::vector<TPoint3Df> points{{far, 0, far}, {far, 0, 0}, {far, 0, -far}};
        const BothWays both(points, {});
        both.expectNothingDone();
        EXPECT_EQ(both.sorted.scan.points,
                  (std::vector<TPoint3Df>{points.rbegin(), points.rend()}));
    }
}

TEST(ColumnBuilder, takesTheListedSlotsOfAStretchOfACloud) {
    const auto points = upwardReturns(20, {});
    std::vector<uint32_t> listed;
    for (uint32_t i = 0; i < points.size(); ++i) listed.push_back(7 * i);
    TurnScan out;
    const CloudArrays arrays(points);
    ASSERT_TRUE(appendColumnInOrder(out, {}, {}, arrays.points(), {0, listed}, 5, 8));
    EXPECT_EQ(out.scan.points, std::vector<TPoint3Df>(points.begin() + 5, points.begin() + 8));
    EXPECT_EQ(out.scan.sourceIndex, (std::vector<uint32_t>{35, 42, 49}));
}

}  // namespace
}  // namespace offmap::rawlog
