// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Scans.h"

#include <offmap/rawlog/PoseCoverage.h>
#include <offmap/rawlog/PoseTrack.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace offmap::rawlog;
using offmap::core::PoseFault;
using testing::ElementsAre;
using testing::Pair;

mrpt::Clock::time_point at(double seconds) { return mrpt::Clock::fromDouble(1.7e9 + seconds); }

StampedPose pose(double seconds, double x, double sigma) {
    StampedPose out;
    out.time = at(seconds);
    out.vehicleInMap.x = x;
    out.groundCovariance = {sigma * sigma, 0, 0, sigma * sigma, 0, 1e-6};
    return out;
}

TEST(PoseCoverage, countsWhatReductionWouldUseAndWhyNot) {
    // The last two are an ellipse of 1.6 m; 0.5 m is the limit.
    const PoseTrack track(
        {pose(0, 0, 0.02), pose(2, 10, 0.02), pose(3, 15, 0.8), pose(3.5, 15, 0.8)}, 0.5);
    offmap::core::MatchingConfig config;
    config.method = offmap::core::MatchingMethod::Paper;
    PoseCoverage coverage(track, config);
    const mrpt::poses::CPose3D mounting;
    for (const double time : {0.0, 0.4, 2.0, 3.2, 3.4, 9.0}) coverage.add(at(time), mounting);
    EXPECT_EQ(coverage.observations(), 6U);
    EXPECT_EQ(coverage.covered(), 3U);  // 0.0, 0.4 and 2.0 s
    EXPECT_THAT(coverage.faults(),
                ElementsAre(Pair(PoseFault::TooOld, 1U), Pair(PoseFault::TooUncertain, 2U)));
    EXPECT_DOUBLE_EQ(coverage.share(), 0.5);
}

TEST(PoseCoverage, withoutScansNothingIsCovered) {
    const PoseTrack track({pose(0, 0, 0.02)}, 0.5);
    const PoseCoverage coverage(track, {});
    EXPECT_EQ(coverage.share(), 0);
}

TEST(PoseCoverage, followsTheVehicle) {
    const PoseTrack track({pose(0, 0, 0.02), pose(10, 20, 0.02)}, 6);
    PoseCoverage coverage(track, {});
    for (int i = 0; i <= 1000; ++i) coverage.follow(at(0.01 * i));
    // Every 0.1 s the interpolated pose is 0.2 m further; a step counts from 0.1 m.
    EXPECT_NEAR(coverage.movement().distance(), 20, 0.3);
    EXPECT_NEAR(coverage.movement().maxSpeed(), 2, 1e-3);
    EXPECT_EQ(coverage.observations(), 0U);
}

TEST(PoseCoverage, errorsInCommonHideNoMovement) {
    const PoseTrack track({pose(0, 0, 2), pose(1, 3, 2)}, 1);
    PoseCoverage single(track, {}), common(track, {}, PoseCoverage::Errors::Common);
    for (PoseCoverage* coverage : {&single, &common}) {
        for (const double time : {0.0, 0.5, 1.0}) coverage->follow(at(time));
    }
    EXPECT_EQ(single.movement().distance(), 0);          // not 3 sigma = 6 m
    EXPECT_NEAR(common.movement().distance(), 3, 1e-6);  // interpolated to a tick of 100 ns
}

}  // namespace
