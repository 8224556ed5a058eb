// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/LivePoses.h>

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace offmap::live {
namespace {

using namespace std::chrono_literals;

const auto start = mrpt::Clock::fromDouble(1.7e9);

rawlog::StampedPose poseAfter(std::chrono::milliseconds passed, double x) {
    rawlog::StampedPose pose;
    pose.time = start + passed;
    pose.vehicleInMap.x = x;
    return pose;
}

TEST(LivePoses, withoutPosesNothingIsSettled) {
    EXPECT_EQ(LivePoses(0.5).settled().until, mrpt::Clock::time_point::min());
}

TEST(LivePoses, areSettledUntilTheNewest) {
    LivePoses poses(0.5);
    poses.add(poseAfter(0ms, 0));
    poses.add(poseAfter(100ms, 1));
    EXPECT_EQ(poses.settled().until, start + 100ms);
    EXPECT_EQ(poses.at(start + 120ms).vehicleInMap->x(), 1) << "the nearest, so far";
    poses.add(poseAfter(200ms, 3));
    EXPECT_NEAR(poses.at(start + 120ms).vehicleInMap->x(), 1.4, 1e-12) << "now between two";
    EXPECT_EQ(poses.settled().until, start + 200ms);
    EXPECT_EQ(poses.settled().revision, 0U);
}

TEST(LivePoses, whatIsSettledStays) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> step(0, 300);  // [ms] two may have the same time
    std::uniform_real_distribution<double> place(-1, 1);
    LivePoses poses(0.1);
    std::vector<std::pair<mrpt::Clock::time_point, rawlog::PoseLookup>> settled;
    std::chrono::milliseconds passed(0);
    for (int i = 0; i < 30; ++i) {
        passed += std::chrono::milliseconds(i % 5 == 0 ? 0 : step(random));
        poses.add(poseAfter(passed, place(random)));
        const auto until = poses.settled().until;
        for (auto time = start - 200ms; time < start + passed + 200ms; time += 7ms) {
            if (time < until) settled.emplace_back(time, poses.at(time));
        }
        if (until > start) settled.emplace_back(until - 1us, poses.at(until - 1us));
    }
    ASSERT_GT(settled.size(), 1000U);
    EXPECT_EQ(poses.settled().revision, 0U);
    for (const auto& [time, before] : settled) {
        const rawlog::PoseLookup now = poses.at(time);
        ASSERT_EQ(now.vehicleInMap.has_value(), before.vehicleInMap.has_value());
        if (!now.vehicleInMap) continue;
        ASSERT_EQ(now.vehicleInMap->x(), before.vehicleInMap->x());
    }
}

TEST(LivePoses, onesThatComeOutOfOrderUnsettleThoseBefore) {
    LivePoses poses(0.5);
    poses.add(poseAfter(0ms, 0));
    poses.add(poseAfter(200ms, 1));
    const auto before = poses.settled();
    EXPECT_NEAR(poses.at(start + 100ms).vehicleInMap->x(), 0.5, 1e-12);
    poses.add(poseAfter(100ms, 7));
    EXPECT_EQ(poses.at(start + 100ms).vehicleInMap->x(), 7);
    EXPECT_NE(poses.settled().revision, before.revision);
    EXPECT_EQ(poses.settled().until, start + 200ms);
}

}  // namespace
}  // namespace offmap::live
