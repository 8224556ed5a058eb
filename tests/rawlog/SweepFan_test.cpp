// SPDX-License-Identifier: BSD-3-Clause
#include "../support/SweepMaker.h"

#include <offmap/rawlog/SweepFan.h>

#include <gtest/gtest.h>

namespace offmap::rawlog {
namespace {

using mrpt::DEG2RAD;
using mrpt::poses::CPose3D;
using test::fanPose;
using test::fanWithoutReturns;

TEST(SweepFan, isVerticalWithinFifteenDegrees) {
    const auto rolled = [](double roll) {
        return isVerticalFan(*fanWithoutReturns(CPose3D(0, 0, 1, 0.3, 0, DEG2RAD(roll))));
    };
    EXPECT_FALSE(rolled(0));
    EXPECT_FALSE(rolled(74.9));
    EXPECT_TRUE(rolled(75.1));
    EXPECT_TRUE(rolled(90));
    EXPECT_TRUE(rolled(104.9));
    EXPECT_FALSE(rolled(105.1));
    EXPECT_TRUE(rolled(-90));
    // Pitched, it still contains the vertical.
    EXPECT_TRUE(isVerticalFan(*fanWithoutReturns(fanPose(20, 60))));
}

TEST(SweepFan, thatPitchesWhileItIsTakenIsNoPlane) {
    auto fan = fanWithoutReturns(fanPose(0));
    fan->deltaPitch = 0.1;
    EXPECT_FALSE(isVerticalFan(*fan));
}

TEST(SweepFan, azimuthIsWhereItsXAxisLooks) {
    for (const double yaw : {-170.0, -90.0, 0.0, 35.0, 120.0}) {
        for (const bool beamsUp : {true, false}) {
            for (const double elevation : {-60.0, 0.0, 70.0}) {
                const auto fan = fanWithoutReturns(fanPose(yaw, elevation, beamsUp));
                ASSERT_EQ(chooseFanAxis(*fan), FanAxis::X);
                EXPECT_NEAR(fanAzimuth(*fan, FanAxis::X), DEG2RAD(yaw), 1e-12);
            }
        }
    }
}

// With its x axis up, and rolled as above, its y axis looks back.
TEST(SweepFan, azimuthIsWhereItsYAxisLooksIfXIsUp) {
    for (const double elevation : {80.0, 90.0, 100.0}) {
        const auto fan = fanWithoutReturns(fanPose(20, elevation));
        ASSERT_EQ(chooseFanAxis(*fan), FanAxis::Y);
        EXPECT_NEAR(fanAzimuth(*fan, FanAxis::Y), DEG2RAD(20.0 - 180.0), 1e-12);
    }
}

TEST(SweepFan, beamsAreWhereMrptHasThem) {
    for (const bool rightToLeft : {true, false}) {
        const auto fan = fanWithoutReturns(fanPose(0), {.rightToLeft = rightToLeft});
        for (size_t i = 0; i < fan->getScanSize(); ++i) {
            // MRPT adds up in single precision, to 1.5 rad.
            EXPECT_NEAR(beamAngle(*fan, i), fan->getScanAngle(i), 1e-6);
        }
    }
}

TEST(SweepFan, singleBeamLooksAlongX) {
    EXPECT_EQ(beamAngle(*fanWithoutReturns(fanPose(0), {.rays = 1}), 0), 0);
}

TEST(SweepFan, beamDirectionsFollowTheScan) {
    BeamDirections beams;
    const auto wide = fanWithoutReturns(fanPose(0), {.aperture = 180, .rays = 3});
    EXPECT_NEAR(beams.of(*wide)[0].y, -1, 1e-7);
    const auto narrow = fanWithoutReturns(fanPose(0), {.aperture = 60, .rays = 3});
    EXPECT_NEAR(beams.of(*narrow)[0].y, -0.5, 1e-7);
    const auto leftToRight =
        fanWithoutReturns(fanPose(0), {.aperture = 60, .rays = 3, .rightToLeft = false});
    EXPECT_NEAR(beams.of(*leftToRight)[0].y, 0.5, 1e-7);
    EXPECT_EQ(beams.of(*fanWithoutReturns(fanPose(0), {.rays = 5})).size(), 5U);
}

}  // namespace
}  // namespace offmap::rawlog
