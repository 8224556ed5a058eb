// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SharedData.h"

#include <offmap/rawlog/CloudColumns.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace offmap::rawlog {
namespace {

using mrpt::DEG2RAD;
using mrpt::math::TPoint3Df;

/// Columns, and the one of each point.
struct Found {
    std::vector<double> azimuths;
    std::vector<uint32_t> columnOf;
};

Found columnsOf(const std::vector<TPoint3Df>& points, double width) {
    const CloudArrays arrays(points);
    const CloudColumns columns = findCloudColumns(arrays.points(), width);
    Found found{columns.azimuths, {}};
    for (const ColumnRun& run : columns.runs) {
        EXPECT_EQ(run.begin, found.columnOf.size());
        EXPECT_LT(run.begin, run.end);
        found.columnOf.resize(run.end, run.column);
    }
    EXPECT_EQ(found.columnOf.size(), points.size());
    return found;
}

TPoint3Df pointAt(double azimuth, double groundRange, double z) {
    return {static_cast<float>(groundRange * std::cos(azimuth)),
            static_cast<float>(groundRange * std::sin(azimuth)), static_cast<float>(z)};
}

/// Columns of 16 points each, at 3 to 4.5 m.
std::vector<TPoint3Df> columnsAt(const std::vector<double>& azimuths) {
    std::vector<TPoint3Df> points;
    for (const double a : azimuths) {
        for (int i = 0; i < 16; ++i) points.push_back(pointAt(a, 3 + 0.1 * i, 0.2 * i));
    }
    return points;
}

std::vector<double> evenAzimuths(int columns, double first, double step) {
    std::vector<double> azimuths;
    for (int c = 0; c < columns; ++c) azimuths.push_back(first + step * c);
    return azimuths;
}

TEST(CloudColumns, exactAzimuthsAreTheColumns) {
    const double step = DEG2RAD(0.5);
    // The first column straddles -pi: rounding leaves its points on both sides.
    const auto azimuths = evenAzimuths(720, -std::numbers::pi, step);
    const auto columns = columnsOf(columnsAt(azimuths), 0);
    ASSERT_EQ(columns.azimuths.size(), 720U);
    for (size_t i = 0; i < columns.columnOf.size(); ++i) {
        const double found = columns.azimuths[columns.columnOf[i]];
        EXPECT_NEAR(mrpt::math::wrapToPi(found - azimuths[i / 16]), 0, 1e-6) << "point " << i;
    }
}

/// [rad] Of a cross product of floats over the squared range, each rounded by 6e-8 of itself: what
/// a cloud stored column by column has in place of azimuths.
constexpr double rounding = 2e-7;

/// The columns must not depend on the order of the points.
void expectSameShuffled(const std::vector<TPoint3Df>& points) {
    std::vector<size_t> order(points.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    std::vector<TPoint3Df> shuffled;
    for (const size_t i : order) shuffled.push_back(points[i]);
    const auto columns = columnsOf(points, 0), other = columnsOf(shuffled, 0);
    ASSERT_EQ(columns.azimuths.size(), other.azimuths.size());
    for (size_t c = 0; c < columns.azimuths.size(); ++c) {
        EXPECT_NEAR(columns.azimuths[c], other.azimuths[c], rounding);
    }
    for (size_t i = 0; i < order.size(); ++i) {
        ASSERT_EQ(columns.columnOf[order[i]], other.columnOf[i]) << order[i];
    }
}

TEST(CloudColumns, orderOfThePointsDoesNotMatter) {
    for (const int count : {36, 360, 1800, 4096}) {
        SCOPED_TRACE(count);
        auto points = columnsAt(evenAzimuths(count, -std::numbers::pi, DEG2RAD(360.0) / count));
        expectSameShuffled(points);
        for (TPoint3Df& p : points) {  // 0.01 degrees at 3 m
            p.x = std::round(1000 * p.x) / 1000;
            p.y = std::round(1000 * p.y) / 1000;
        }
        expectSameShuffled(points);
        for (size_t i = 0; i < points.size(); i += 7)
            points[i] = pointAt(0.01 * static_cast<double>(i), 0.3, 2);
        expectSameShuffled(points);
    }
}

TEST(CloudColumns, columnsStoredInSeveralPiecesAreWhole) {
    const auto once = columnsAt(evenAzimuths(300, -2.0, DEG2RAD(0.5)));
    auto twice = once;
    twice.insert(twice.end(), once.rbegin(), once.rend());
    EXPECT_EQ(columnsOf(twice, 0).azimuths.size(), 300U);
    expectSameShuffled(twice);
}

TEST(CloudColumns, columnsFinerThanAnArcAreToldApart) {
    const auto fine = columnsAt(evenAzimuths(900, 0.5, DEG2RAD(0.015)));
    EXPECT_EQ(columnsOf(fine, 0).azimuths.size(), 900U);
    expectSameShuffled(fine);
}

TEST(CloudColumns, whereTheTurnBeginsAndWhichWayRoundItGoesDoesNotMatter) {
    auto azimuths = evenAzimuths(360, -3.1, DEG2RAD(1.0));
    const auto columns = columnsOf(columnsAt(azimuths), 0);
    for (const int turned : {0, 1, 100, 359}) {
        std::rotate(azimuths.begin(), azimuths.begin() + turned, azimuths.end());
        std::reverse(azimuths.begin(), azimuths.end());
        const auto points = columnsAt(azimuths);
        const auto other = columnsOf(points, 0);
        ASSERT_EQ(other.azimuths.size(), columns.azimuths.size());
        for (size_t c = 0; c < columns.azimuths.size(); ++c) {
            EXPECT_NEAR(columns.azimuths[c], other.azimuths[c], rounding);
        }
        expectSameShuffled(points);
    }
}

TEST(CloudColumns, sectorHasColumnsOfItsOwn) {
    const auto azimuths = evenAzimuths(90, -0.8, DEG2RAD(1.0));
    EXPECT_EQ(columnsOf(columnsAt(azimuths), 0).azimuths.size(), 90U);
}

TEST(CloudColumns, missingColumnsLeaveTheOthersAlone) {
    auto azimuths = evenAzimuths(360, -3.0, DEG2RAD(1.0));
    azimuths.erase(azimuths.begin() + 100, azimuths.begin() + 103);
    EXPECT_EQ(columnsOf(columnsAt(azimuths), 0).azimuths.size(), 357U);
}

TEST(CloudColumns, pointsNearTheVerticalAxisBlurNothing) {
    const auto azimuths = evenAzimuths(360, -3.0, DEG2RAD(1.0));
    auto points = columnsAt(azimuths);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-std::numbers::pi, std::numbers::pi);
    for (int i = 0; i < 2000; ++i) points.push_back(pointAt(anywhere(random), 0.02, 2));
    const auto columns = columnsOf(points, 0);
    ASSERT_EQ(columns.azimuths.size(), 360U);
    for (size_t i = azimuths.size() * 16; i < points.size(); ++i) {
        const double azimuth = std::atan2(points[i].y, points[i].x);
        const double off = mrpt::math::wrapToPi(columns.azimuths[columns.columnOf[i]] - azimuth);
        EXPECT_LE(std::abs(off), DEG2RAD(0.5) + 1e-6);
    }
}

TEST(CloudColumns, columnsNearTheVerticalAxisAreColumnsToo) {
    auto points = columnsAt(evenAzimuths(360, -3.0, DEG2RAD(1.0)));
    for (size_t i = 40 * 16; i < 120 * 16; ++i) {  // beside a wall
        const double azimuth = std::atan2(points[i].y, points[i].x);
        points[i] = pointAt(azimuth, 0.3 + 0.001 * static_cast<double>(i % 16), 0.02);
    }
    EXPECT_EQ(columnsOf(points, 0).azimuths.size(), 360U);
    expectSameShuffled(points);
}

TEST(CloudColumns, whatIsRoundedBesideAWallDoesNotBlurTheOthers) {
    auto points = columnsAt(evenAzimuths(360, -3.0, DEG2RAD(1.0)));
    std::mt19937 random(4);
    std::uniform_real_distribution<double> range(0.1, 0.4);
    const auto rounded = [](float x) { return std::round(100 * x) / 100; };  // to 1 cm
    for (size_t i = 40 * 16; i < 120 * 16; ++i) {
        const double azimuth = std::atan2(points[i].y, points[i].x);
        const TPoint3Df near = pointAt(azimuth, range(random), 0.02);
        points[i] = {rounded(near.x), rounded(near.y), near.z};
    }
    const auto columns = columnsOf(points, 0);
    for (size_t i = 0; i < points.size(); ++i) {
        if (std::hypot(points[i].x, points[i].y) < 1) continue;
        const double azimuth = std::atan2(points[i].y, points[i].x);
        EXPECT_NEAR(columns.azimuths[columns.columnOf[i]], azimuth, 1e-6);
    }
    expectSameShuffled(points);
}

TEST(CloudColumns, azimuthsAtRandomGetFixedBins) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-std::numbers::pi, std::numbers::pi);
    std::vector<TPoint3Df> points;
    for (int i = 0; i < 28'800; ++i) points.push_back(pointAt(anywhere(random), 3, 0));
    const auto columns = columnsOf(points, 0);
    // 32 points a column are 900 columns of 0.4 degrees; a bin without a point has odds of e^-32.
    ASSERT_EQ(columns.azimuths.size(), 900U);
    for (size_t i = 0; i < points.size(); ++i) {
        const double azimuth = std::atan2(points[i].y, points[i].x);
        const double off = columns.azimuths[columns.columnOf[i]] - azimuth;
        EXPECT_LE(std::abs(off), DEG2RAD(0.2) + 1e-6);
    }
}

TEST(CloudColumns, evenlySpreadAzimuthsGetFixedBins) {
    std::vector<TPoint3Df> points;
    for (int i = 0; i < 3600; ++i) points.push_back(pointAt(DEG2RAD(0.1) * i - 3, 2, 1));
    // 32 * 0.1 degrees are more than the widest column, 2 degrees.
    EXPECT_EQ(columnsOf(points, 0).azimuths.size(), 180U);
}

TEST(CloudColumns, givenWidthClosesAroundTheCircle) {
    const auto points = columnsAt(evenAzimuths(720, -3.0, DEG2RAD(0.5)));
    EXPECT_EQ(columnsOf(points, DEG2RAD(7.0)).azimuths.size(), 51U);  // 360 / 51 = 7.06
}

TEST(CloudColumns, cloudWithoutPointsHasNone) {
    EXPECT_TRUE(columnsOf({}, 0).azimuths.empty());
    EXPECT_TRUE(columnsOf({}, 0.01).azimuths.empty());
}

TEST(CloudColumns, onePointIsOneColumn) {
    const std::vector<TPoint3Df> one = {{1, 0, 0}};
    EXPECT_EQ(columnsOf(one, 0).columnOf, std::vector<uint32_t>{0});
}

// The scanner took two profiles at each azimuth, and several while it began to turn.
TEST(CloudColumns, realTurnHasTheColumnsOfItsProfiles) {
    OFFMAP_NEEDS_SHARED_DATA()
    const auto scans = test::observationsIn<mrpt::obs::CObservation2DRangeScan>(
        test::sharedData("room/room1.rawlog"));
    std::vector<double> profiles;
    for (const auto& scan : scans) profiles.push_back(scan->sensorPose.yaw());
    std::sort(profiles.begin(), profiles.end());
    size_t apart = 1;  // first and last are, by 0.5 degrees or more
    for (size_t i = 1; i < profiles.size(); ++i) {
        if (profiles[i] - profiles[i - 1] > DEG2RAD(0.5)) ++apart;
    }
    const auto clouds = test::observationsIn<mrpt::obs::CObservationPointCloud>(
        test::sharedData("room/room1_points.rawlog"));
    ASSERT_EQ(clouds.size(), 1U);
    std::vector<TPoint3Df> points;
    for (size_t i = 0; i < clouds[0]->pointcloud->size(); ++i) {
        points.emplace_back();
        clouds[0]->pointcloud->getPointFast(i, points.back().x, points.back().y, points.back().z);
    }
    EXPECT_EQ(columnsOf(points, 0).azimuths.size(), apart);
}

}  // namespace
}  // namespace offmap::rawlog
