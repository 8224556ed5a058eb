// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/PoseTrack.h>

#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <cmath>
#include <limits>

namespace {

using namespace offmap::rawlog;
using mrpt::math::TPose3D;
using offmap::core::PoseFault;

// Slerp takes the arc cosine of a number near 1: half of the digits are lost.
constexpr double slerpTolerance = 1e-7;  // [rad]
constexpr double rounding = 1e-12;

mrpt::Clock::time_point second(double seconds) {
    constexpr int64_t someDay = 133'000'000'000'000'000;  // in ticks of 100 ns
    return mrpt::Clock::time_point(
        mrpt::Clock::duration(someDay + static_cast<int64_t>(std::round(seconds * 1e7))));
}

mrpt::obs::CObservationRobotPose observed(double seconds, const TPose3D& pose,
                                          double sigmaPosition = 0.05, double sigmaYaw = 0.02) {
    mrpt::obs::CObservationRobotPose observation;
    observation.timestamp = second(seconds);
    observation.pose.mean = mrpt::poses::CPose3D(pose);
    observation.pose.cov.setZero();
    for (int i = 0; i < 3; ++i) observation.pose.cov(i, i) = sigmaPosition * sigmaPosition;
    for (int i = 3; i < 6; ++i) observation.pose.cov(i, i) = sigmaYaw * sigmaYaw;
    return observation;
}

StampedPose stamped(double seconds, const TPose3D& pose, double sigmaPosition = 0.05,
                    double sigmaYaw = 0.02) {
    return stampedPose(observed(seconds, pose, sigmaPosition, sigmaYaw));
}

TPose3D poseAt(const PoseTrack& track, double seconds) {
    const PoseLookup lookup = track.at(second(seconds));
    EXPECT_TRUE(lookup.vehicleInMap) << seconds;
    return lookup.vehicleInMap ? lookup.vehicleInMap->asTPose() : TPose3D();
}

std::optional<PoseFault> faultAt(const PoseTrack& track, double seconds) {
    const PoseLookup lookup = track.at(second(seconds));
    return lookup.vehicleInMap ? std::nullopt : std::optional(lookup.fault);
}

TEST(PoseTrack, poseIsStoredCompactly) { EXPECT_LE(sizeof(StampedPose), 120U); }

TEST(PoseTrack, withoutPosesThereIsNone) {
    const PoseTrack track({});
    EXPECT_EQ(faultAt(track, 0), PoseFault::NoPose);
    EXPECT_EQ(track.size(), 0U);
    EXPECT_FALSE(track.begin());
    EXPECT_FALSE(track.end());
}

TEST(PoseTrack, unsortedPosesAreSorted) {
    const PoseTrack track({stamped(2, {20, 0, 0, 0, 0, 0}), stamped(0, {0, 0, 0, 0, 0, 0}),
                           stamped(1, {10, 0, 0, 0, 0, 0})});
    EXPECT_EQ(track.size(), 3U);
    EXPECT_EQ(track.begin(), second(0));
    EXPECT_EQ(track.end(), second(2));
    EXPECT_NEAR(poseAt(track, 0.25).x, 2.5, rounding);
    EXPECT_NEAR(poseAt(track, 1.75).x, 17.5, rounding);
    EXPECT_EQ(poseAt(track, 1.0).x, 10);
}

TEST(PoseTrack, meanAndCovarianceAreInterpolated) {
    auto from = observed(0, {1, 2, 3, 0.1, 0.02, -0.04}, 0.1, 0.01);
    from.pose.cov(0, 1) = from.pose.cov(1, 0) = 0.004;
    from.pose.cov(1, 3) = from.pose.cov(3, 1) = 0.0002;
    const auto to = observed(0.4, {3, 1, 3.5, 0.3, 0.02, -0.04}, 0.2, 0.03);
    const PoseTrack track({stampedPose(from), stampedPose(to)});

    const TPose3D pose = poseAt(track, 0.1);  // a quarter of the way
    EXPECT_NEAR(pose.x, 1.5, rounding);
    EXPECT_NEAR(pose.y, 1.75, rounding);
    EXPECT_NEAR(pose.z, 3.125, rounding);
    // The turn is about an axis that pitch and roll tilt by 0.045 rad: yaw is linear to 0.045^2.
    EXPECT_NEAR(pose.yaw, 0.15, 0.2 * 0.045 * 0.045);

    const Eigen::Matrix3d covariance = track.at(second(0.1)).groundCovariance;
    EXPECT_NEAR(covariance(0, 0), 0.75 * 0.01 + 0.25 * 0.04, rounding);
    EXPECT_NEAR(covariance(0, 1), 0.75 * 0.004, rounding);
    EXPECT_NEAR(covariance(1, 2), 0.75 * 0.0002, rounding);
    EXPECT_NEAR(covariance(2, 2), 0.75 * 0.0001 + 0.25 * 0.0009, rounding);
    EXPECT_EQ(covariance, covariance.transpose());
}

TEST(PoseTrack, yawIsInterpolatedThroughPi) {
    const PoseTrack track(
        {stamped(0, {0, 0, 0, M_PI - 0.1, 0, 0}), stamped(0.4, {0, 0, 0, -M_PI + 0.3, 0, 0})});
    EXPECT_NEAR(mrpt::math::wrapToPi(poseAt(track, 0.1).yaw - M_PI), 0, slerpTolerance);
    EXPECT_NEAR(poseAt(track, 0.3).yaw, -M_PI + 0.2, slerpTolerance);
}

TEST(PoseTrack, uprightPosesTurnAsThoseThatHardlyLean) {
    for (const double lean : {0.0, 1e-9}) {
        const PoseTrack track(
            {stamped(0, {0, 0, 0, 2.9, lean, 0}), stamped(0.4, {0, 0, 0, -3.1, 0, lean})});
        for (const double share : {0.0, 0.25, 0.5, 1.0}) {
            const double turned = share * (2 * M_PI - 6);
            EXPECT_NEAR(mrpt::math::wrapToPi(poseAt(track, 0.4 * share).yaw - 2.9), turned,
                        lean > 0 ? slerpTolerance : rounding);
        }
    }
}

TEST(PoseTrack, nothingIsExtrapolated) {
    const PoseTrack track({stamped(0, {0, 0, 0, 0, 0, 0}), stamped(1, {10, 0, 0, 0, 0, 0})}, 0.5);
    EXPECT_EQ(poseAt(track, -0.5).x, 0);
    EXPECT_EQ(poseAt(track, 1.5).x, 10);
    EXPECT_EQ(faultAt(track, -0.5000001), PoseFault::TooOld);
    EXPECT_EQ(faultAt(track, 1.5000001), PoseFault::TooOld);
    EXPECT_EQ(faultAt(track, 1e9), PoseFault::TooOld);
}

TEST(PoseTrack, singlePoseServesItsSurroundings) {
    const PoseTrack track({stamped(0, {1, 2, 0, 0.5, 0, 0})}, 0.1);
    EXPECT_EQ(poseAt(track, -0.1).x, 1);
    EXPECT_EQ(poseAt(track, 0.1).y, 2);
    EXPECT_EQ(faultAt(track, 0.2), PoseFault::TooOld);
}

TEST(PoseTrack, standingRobotHasAPoseInAGapOfMinutes) {
    // Differences within 3 sigma of the two together: 3 * sqrt(2) * 0.05 m = 0.212 m.
    const PoseTrack track(
        {stamped(0, {1, 2, 0, M_PI - 0.01, 0, 0}), stamped(600, {1.2, 2, 0, -M_PI + 0.01, 0, 0})});
    EXPECT_NEAR(poseAt(track, 300).x, 1.1, rounding);
    EXPECT_NEAR(mrpt::math::wrapToPi(poseAt(track, 300).yaw - M_PI), 0, slerpTolerance);
}

TEST(PoseTrack, movedRobotHasNoPoseInAGap) {
    // Just over 3 sigma in x, and in yaw: 3 * sqrt(2) * 0.02 rad = 0.085 rad.
    for (const TPose3D& moved : {TPose3D(0.22, 0, 0, 0, 0, 0), TPose3D(0, 0, 0, 0.09, 0, 0)}) {
        const PoseTrack track({stamped(0, {0, 0, 0, 0, 0, 0}), stamped(10, moved)});
        EXPECT_EQ(faultAt(track, 5), PoseFault::TooOld);
        EXPECT_FALSE(faultAt(track, 0.5));
        EXPECT_EQ(faultAt(track, 0.51), PoseFault::TooOld);
        EXPECT_FALSE(faultAt(track, 9.5));
    }
}

TEST(PoseTrack, perfectPosesAgreeWithinTheFloor) {
    const auto agrees = [](const TPose3D& second) {
        return !faultAt(
            PoseTrack({stamped(0, {0, 0, 0, 0, 0, 0}, 0, 0), stamped(10, second, 0, 0)}), 5);
    };
    EXPECT_TRUE(agrees({0, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(agrees({0.0029, 0, 0, 0, 0, 0}));  // 3 times 1 mm
    EXPECT_FALSE(agrees({0.0031, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(agrees({0, 0, 0, mrpt::DEG2RAD(0.149), 0, 0}));  // 3 times 0.05 degrees
    EXPECT_FALSE(agrees({0, 0, 0, mrpt::DEG2RAD(0.151), 0, 0}));
}

TEST(PoseTrack, equalStampsDoNotMatter) {
    const PoseTrack track({stamped(0, {0, 0, 0, 0, 0, 0}), stamped(1, {5, 0, 0, 0, 0, 0}),
                           stamped(1, {6, 0, 0, 0, 0, 0}), stamped(2, {8, 0, 0, 0, 0, 0})});
    EXPECT_EQ(poseAt(track, 1).x, 6);
    EXPECT_NEAR(poseAt(track, 0.5).x, 2.5, rounding);
    EXPECT_NEAR(poseAt(track, 1.5).x, 7, rounding);
}

TEST(PoseTrack, faultyPoseIsTold) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    auto nanMean = observed(1, {});
    nanMean.pose.mean = mrpt::poses::CPose3D(nan, 0, 0, 0, 0, 0);
    auto infiniteHeight = observed(1, {});
    infiniteHeight.pose.cov(2, 2) = std::numeric_limits<double>::infinity();
    auto notPsd = observed(1, {});
    notPsd.pose.cov(0, 1) = notPsd.pose.cov(1, 0) = 1.0;
    EXPECT_EQ(stampedPose(nanMean).fault, PoseFault::NotFinite);
    EXPECT_EQ(stampedPose(infiniteHeight).fault, PoseFault::NotFinite);
    EXPECT_EQ(stampedPose(notPsd).fault, PoseFault::NotPsd);
    EXPECT_EQ(stampedPose(observed(1, {})).fault, std::nullopt);

    const PoseTrack track({stamped(0, {}), stampedPose(notPsd), stamped(2, {}), stamped(3, {})});
    EXPECT_FALSE(faultAt(track, 0));  // its own pose: no other is touched
    EXPECT_EQ(faultAt(track, 0.1), PoseFault::NotPsd);
    EXPECT_EQ(faultAt(track, 1), PoseFault::NotPsd);
    EXPECT_EQ(faultAt(track, 1.9), PoseFault::NotPsd);
    EXPECT_FALSE(faultAt(track, 2.1));
}

TEST(PoseTrack, nanAngleIsTold) {
    auto observation = observed(0, {});
    observation.pose.mean.setYawPitchRoll(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    EXPECT_EQ(stampedPose(observation).fault, PoseFault::NotFinite);
}

TEST(PoseTrack, stampsAtTheEndsOfTimeAreHarmless) {
    auto first = stamped(0, {0, 0, 0, 0, 0, 0}), last = stamped(0, {9, 0, 0, 0, 0, 0});
    first.time = mrpt::Clock::time_point::min();
    last.time = mrpt::Clock::time_point::max();
    EXPECT_EQ(faultAt(PoseTrack({first, last}), 0), PoseFault::TooOld);
}

TEST(PoseTrack, refusesAnImpossibleAge) {
    EXPECT_THROW(PoseTrack({}, -0.1), std::invalid_argument);
    EXPECT_THROW(PoseTrack({}, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
