// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"
#include "../support/SharedData.h"
#include "../support/SweepMaker.h"

#include <offmap/rawlog/SweepColumns.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <cmath>
#include <numbers>

namespace offmap::rawlog {
namespace {

using namespace std::chrono_literals;
using mrpt::DEG2RAD;
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;
using test::Fan;
using test::fanIn;
using test::fanPose;

const test::DrivenVehicle atOrigin{CPose3D()};

/// [m] Single precision of ranges and coordinates up to 20 m, of aperture and beam angles.
constexpr double floatError = 20 * 1e-6;

TPoint3D inMap(const TurnScan& turn, const core::ScanColumn& column, size_t point) {
    return column.sensor->sensorInMap.composePoint(TPoint3D(turn.scan.points[point]));
}

/// Every point must stand in the map where its ray ended, whichever column it went to.
void expectPointsWhereTheirRaysEnd(const TurnScan& turn, const Turn& fans,
                                   const std::function<CPose3D(const Fan&)>& vehicleInMap) {
    const size_t rays = dynamic_cast<const Fan&>(*fans[0]).getScanSize();
    for (const auto& column : turn.scan.columns) {
        ASSERT_TRUE(column.sensor);
        for (size_t p = column.begin; p < column.end; ++p) {
            const uint32_t slot = turn.scan.sourceIndex[p];
            const auto& fan = dynamic_cast<const Fan&>(*fans[slot / rays]);
            const size_t ray = slot % rays;
            const TPoint3D end = (vehicleInMap(fan) + fan.sensorPose)
                                     .composePoint(test::rayDirection(fan, ray) *
                                                   static_cast<double>(fan.getScanRange(ray)));
            EXPECT_LE((inMap(turn, column, p) - end).norm(), floatError) << "slot " << slot;
        }
    }
}

/// Seen from its sensor, in the vehicle's axes, every point lies at its column's azimuth, above
/// those before it.
void expectUprightColumns(const TurnScan& turn, double tolerance) {
    size_t next = 0;
    for (const auto& column : turn.scan.columns) {
        EXPECT_EQ(column.begin, next);
        next = column.end;
        double elevation = -std::numbers::pi;
        for (size_t p = column.begin; p < column.end; ++p) {
            const TPoint3D seen =
                CPose3D(column.sensorInVehicle).rotateVector(TPoint3D(turn.scan.points[p]));
            const double ground = std::hypot(seen.x, seen.y);
            const double off = mrpt::math::wrapToPi(std::atan2(seen.y, seen.x) - column.azimuth);
            EXPECT_LE(ground * std::abs(std::sin(off)), tolerance);
            // Within a millirad of the vertical, a point may lie on the other side.
            if (ground > 2e-3 * seen.norm()) {
                EXPECT_LE(std::abs(off), std::numbers::pi / 2);
            }
            EXPECT_GE(std::atan2(seen.z, ground), elevation - 2e-3);
            elevation = std::atan2(seen.z, ground);
        }
    }
    EXPECT_EQ(next, turn.scan.points.size());
}

Turn fullTurn(int columns, double elevation, const test::FanOptions& options, bool beamsUp = true,
              bool clockwise = false) {
    Turn fans;
    for (int c = 0; c < columns; ++c) {
        const double yaw = (clockwise ? -360.0 : 360.0) * c / columns;
        fans.push_back(fanIn(test::room(), fanPose(yaw, elevation, beamsUp), options));
    }
    return fans;
}

TEST(SweepColumns, wallAheadStandsAtItsRangeHoweverTheScannerIsMounted) {
    for (const bool beamsUp : {true, false}) {
        for (const bool rightToLeft : {true, false}) {
            const Turn fans = {fanIn(test::wallAhead(4), fanPose(0, 0, beamsUp),
                                     {.aperture = 120, .rays = 121, .rightToLeft = rightToLeft})};
            const TurnScan turn = organizeSweep(fans, atOrigin, {});
            ASSERT_EQ(turn.scan.columns.size(), 1U);
            ASSERT_EQ(turn.scan.points.size(), 121U);
            EXPECT_NEAR(turn.scan.columns[0].azimuth, 0, 1e-7);
            for (size_t p = 0; p < 121; ++p) {
                const TPoint3D point = inMap(turn, turn.scan.columns[0], p);
                const double elevation = DEG2RAD(static_cast<double>(p) - 60.0);
                EXPECT_NEAR(point.x, 4, floatError);
                EXPECT_NEAR(point.y, 0, floatError);
                EXPECT_NEAR(point.z, 1 + 4 * std::tan(elevation), floatError);
            }
            // The scan's own frame: a plane.
            for (const auto& p : turn.scan.points) EXPECT_EQ(p.z, 0);
        }
    }
}

TEST(SweepColumns, turnStandsInTheOrderOfRotation) {
    for (const bool clockwise : {false, true}) {
        for (const bool beamsUp : {false, true}) {
            const Turn fans = fullTurn(90, 0, {}, beamsUp, clockwise);
            const TurnScan turn = organizeSweep(fans, atOrigin, {});
            ASSERT_EQ(turn.scan.columns.size(), 90U);
            EXPECT_EQ(turn.scan.points.size(), 90U * 171);
            for (size_t c = 0; c < 90; ++c) {
                const double yaw = DEG2RAD((clockwise ? -4.0 : 4.0) * static_cast<double>(c));
                EXPECT_NEAR(mrpt::math::wrapToPi(turn.scan.columns[c].azimuth - yaw), 0, 1e-6);
            }
            expectUprightColumns(turn, floatError);
            expectPointsWhereTheirRaysEnd(turn, fans, [](const Fan&) { return CPose3D(); });
        }
    }
}

// Beams from -60 to 180 degrees of elevation: those past 90 look back.
TEST(SweepColumns, beamsPastTheZenithJoinTheOppositeColumn) {
    const Turn fans = fullTurn(90, 60, {.aperture = 240, .rays = 241});
    const TurnScan turn = organizeSweep(fans, atOrigin, {});
    ASSERT_EQ(turn.scan.columns.size(), 90U);
    EXPECT_EQ(turn.scan.points.size(), 90U * 241);
    const auto& column = turn.scan.columns[10];
    size_t fromOwn = 0, fromOpposite = 0;
    for (size_t p = column.begin; p < column.end; ++p) {
        if (turn.scan.sourceIndex[p] / 241 == 10) ++fromOwn;
        if (turn.scan.sourceIndex[p] / 241 == 55) ++fromOpposite;
    }
    EXPECT_EQ(fromOwn, 151U);      // -60 to 90 degrees
    EXPECT_EQ(fromOpposite, 90U);  // 91 to 180
    EXPECT_EQ(column.end - column.begin, 241U);
    expectUprightColumns(turn, floatError);
    expectPointsWhereTheirRaysEnd(turn, fans, [](const Fan&) { return CPose3D(); });
}

TEST(SweepColumns, beamsPastTheNadirJoinTheOppositeColumn) {
    const Turn fans = fullTurn(90, -60, {.aperture = 120, .rays = 121}, false);
    const TurnScan turn = organizeSweep(fans, atOrigin, {});
    ASSERT_EQ(turn.scan.columns.size(), 90U);
    expectUprightColumns(turn, floatError);
    expectPointsWhereTheirRaysEnd(turn, fans, [](const Fan&) { return CPose3D(); });
}

TEST(SweepColumns, fanThatLooksUpBelongsToBothSides) {
    const Turn fans = fullTurn(90, 90, {.aperture = 160, .rays = 161});
    const TurnScan turn = organizeSweep(fans, atOrigin, {});
    ASSERT_EQ(turn.scan.columns.size(), 90U);
    expectUprightColumns(turn, floatError);
    expectPointsWhereTheirRaysEnd(turn, fans, [](const Fan&) { return CPose3D(); });
}

TEST(SweepColumns, withoutAnOppositeColumnTheyMakeTheirOwn) {
    Turn fans;
    for (int c = 0; c < 40; ++c) {
        fans.push_back(fanIn(test::room(), fanPose(4.0 * c, 60), {.aperture = 240, .rays = 241}));
    }
    const TurnScan turn = organizeSweep(fans, atOrigin, {});
    ASSERT_EQ(turn.scan.columns.size(), 80U);
    for (size_t c = 40; c < 80; ++c) {
        const double wanted = DEG2RAD(4.0 * static_cast<double>(c - 40) + 180);
        EXPECT_NEAR(mrpt::math::wrapToPi(turn.scan.columns[c].azimuth - wanted), 0, 1e-6);
        EXPECT_EQ(turn.scan.columns[c].end - turn.scan.columns[c].begin, 90U);
        EXPECT_EQ(turn.scan.columns[c].time, turn.scan.columns[c - 40].time);
    }
    expectUprightColumns(turn, floatError);
    expectPointsWhereTheirRaysEnd(turn, fans, [](const Fan&) { return CPose3D(); });
}

/// 10 ms a column, 90 columns, all past the zenith.
Turn drivenTurn() {
    Turn fans;
    for (int c = 0; c < 90; ++c) {
        fans.push_back(fanIn(test::room(), fanPose(4.0 * c, 60),
                             {.aperture = 240, .rays = 241, .time = 10ms * c}));
    }
    return fans;
}

CPose3D drivenPose(mrpt::Clock::time_point time) {
    const double s = mrpt::system::timeDifference(mrpt::Clock::fromDouble(1.7e9), time);
    return {1 + 0.5 * s, 2 * s, 0.1, 0.3 + 0.4 * s, 0.02, 0.01};
}

TEST(SweepColumns, movementComesFromTheVehicleIfTheMountingStands) {
    const Turn fans = drivenTurn();
    for (const auto reference : {PoseReference::Auto, PoseReference::Column}) {
        SensorConfig config;
        config.poseReference = reference;
        const TurnScan turn = organizeSweep(fans, test::DrivenVehicle(drivenPose), config);
        ASSERT_EQ(turn.scan.columns.size(), 90U);
        expectPointsWhereTheirRaysEnd(turn, fans,
                                      [](const Fan& f) { return drivenPose(f.timestamp); });
    }
}

TEST(SweepColumns, movementIsInTheMountingIfThatVaries) {
    const Turn fans = drivenTurn();
    const CPose3D first = drivenPose(fans[0]->timestamp);
    SensorConfig config;
    config.poseReference = PoseReference::Turn;
    expectPointsWhereTheirRaysEnd(organizeSweep(fans, test::DrivenVehicle(drivenPose), config),
                                  fans, [&](const Fan&) { return first; });

    Turn moving;
    for (int c = 0; c < 90; ++c) {
        const auto pose = fanPose(4.0 * c, 60, true, {0.002 * c, 0, 1});
        moving.push_back(
            fanIn(test::room(), pose, {.aperture = 240, .rays = 241, .time = 10ms * c}));
    }
    expectPointsWhereTheirRaysEnd(
        organizeSweep(moving, test::DrivenVehicle(drivenPose), SensorConfig()), moving,
        [&](const Fan&) { return first; });
}

TEST(SweepColumns, withoutAPoseTheMountingPlacesTheMovedBeams) {
    const Turn fans = fullTurn(90, 60, {.aperture = 240, .rays = 241});
    const TurnScan turn = organizeSweep(fans, test::LostVehicle(), {});
    for (const auto& column : turn.scan.columns) {
        EXPECT_FALSE(column.sensor);
        EXPECT_EQ(column.fault, core::PoseFault::TooOld);
    }
    expectUprightColumns(turn, floatError);
}

TEST(SweepColumns, whatIsNoReturnIsCountedAndLeftOut) {
    auto fan = fanIn(test::wallAhead(2), fanPose(0), {.aperture = 40, .rays = 5});
    fan->setScanRangeValidity(0, false);
    fan->setScanRange(1, std::numeric_limits<float>::quiet_NaN());
    fan->setScanRange(2, std::numeric_limits<float>::infinity());
    fan->setScanRange(3, 0);
    const TurnScan turn = organizeSweep({fan, fan}, atOrigin, {});
    EXPECT_EQ(turn.scan.sourceIndex, (std::vector<uint32_t>{4, 9}));
    EXPECT_EQ(turn.counts.returns, 2U);
    EXPECT_EQ(turn.counts.zero, 4U);
    EXPECT_EQ(turn.counts.nonFinite, 4U);
}

TEST(SweepColumns, columnWithoutReturnsStaysEmpty) {
    const TurnScan turn = organizeSweep({test::fanWithoutReturns(fanPose(0))}, atOrigin, {});
    ASSERT_EQ(turn.scan.columns.size(), 1U);
    EXPECT_EQ(turn.scan.columns[0].begin, turn.scan.columns[0].end);
    EXPECT_TRUE(organizeSweep({}, atOrigin, {}).scan.columns.empty());
}

TEST(SweepColumns, realTurnKeepsAllReturns) {
    OFFMAP_NEEDS_SHARED_DATA()
    Turn fans;
    for (const auto& fan : test::observationsIn<Fan>(test::sharedData("room/room1.rawlog"))) {
        fans.push_back(fan);
    }
    const TurnScan turn = organizeSweep(fans, atOrigin, {});
    EXPECT_EQ(turn.counts.returns, 88904U);
    EXPECT_EQ(turn.scan.points.size() + turn.counts.duplicates, 88904U);
    EXPECT_EQ(turn.scan.columns.size(), 636U);
    expectPointsWhereTheirRaysEnd(turn, fans, [](const Fan&) { return CPose3D(); });
}

}  // namespace
}  // namespace offmap::rawlog
