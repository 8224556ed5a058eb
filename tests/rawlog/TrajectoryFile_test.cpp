// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/TrajectoryFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/poses/CPose3DInterpolator.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace offmap::rawlog {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double rounding = 1e-12;

class TrajectoryFile : public testing::Test {
 protected:
    std::vector<StampedPose> read(const std::string& text) {
        test::writeFile(file_, text);
        return readTrajectory(file_, 0.05, 0.02);
    }

    std::string errorOf(const std::string& text) {
        try {
            read(text);
        } catch (const std::runtime_error& e) {
            return e.what();
        }
        return "no error";
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "run7.tum";
};

TEST_F(TrajectoryFile, tumIsRead) {
    const double half = M_PI / 8;  // of a turn by 45 degrees about z
    const auto poses =
        read("# t x y z qx qy qz qw\n1700000000.25 1 2 0.5 0 0 " + std::to_string(std::sin(half)) +
             " " + std::to_string(std::cos(half)) + "\n");
    ASSERT_EQ(poses.size(), 1U);
    EXPECT_EQ(poses[0].time, mrpt::Clock::fromDouble(1700000000.25));
    const auto& pose = poses[0].vehicleInMap;
    EXPECT_EQ(pose.x, 1);
    EXPECT_EQ(pose.y, 2);
    EXPECT_EQ(pose.z, 0.5);
    EXPECT_NEAR(pose.yaw, M_PI / 4, 2e-6);  // six decimals of the sine and the cosine of the half
    EXPECT_NEAR(pose.pitch, 0, rounding);
    EXPECT_NEAR(pose.roll, 0, rounding);
    EXPECT_EQ(poses[0].groundCovariance, (GroundTriangle{0.05 * 0.05, 0, 0, 0.05 * 0.05, 0, 4e-4}));
    EXPECT_FALSE(poses[0].fault);
}

TEST_F(TrajectoryFile, quaternionIsNotConfusedInItsOrder) {
    // A quarter turn about x, then y: roll, then pitch alone.
    const auto poses = read("1 0 0 0 0.70710678 0 0 0.70710678\n2 0 0 0 0 0.6 0 0.8\n");
    EXPECT_NEAR(poses.at(0).vehicleInMap.roll, M_PI / 2, 1e-7);
    EXPECT_NEAR(poses.at(1).vehicleInMap.pitch, 2 * std::asin(0.6), 1e-7);
}

TEST_F(TrajectoryFile, textOfMrptIsRead) {
    mrpt::poses::CPose3DInterpolator written;
    const mrpt::math::TPose3D pose(1.5, -2.25, 0.125, -3, 0.25, -0.5);
    written.insert(mrpt::Clock::fromDouble(1700000000.5), pose);
    written.insert(mrpt::Clock::fromDouble(1700000001.5), mrpt::math::TPose3D(2, 3, 4, 1, 0, 0));
    written.saveToTextFile(file_.string());
    const auto poses = readTrajectory(file_, 0, 0);
    ASSERT_EQ(poses.size(), 2U);
    EXPECT_EQ(poses[0].time, mrpt::Clock::fromDouble(1700000000.5));
    // It writes six decimals.
    for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(poses[0].vehicleInMap[i], pose[i], 6e-7) << i;
}

TEST_F(TrajectoryFile, unsortedTimesAreSorted) {
    const auto poses = read("3 30 0 0 0 0 0\n1 10 0 0 0 0 0\n2 20 0 0 0 0 0\n");
    ASSERT_EQ(poses.size(), 3U);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_EQ(poses[i].vehicleInMap.x, 10.0 * (1.0 + static_cast<double>(i)));
}

TEST_F(TrajectoryFile, separatorsAndCommentsAreTolerated) {
    const auto poses = read(
        "#time,x,y,z,...\r\n\r\n1,10, 0,0,0,0,0\r\n\t2\t20\t0 0 0 0 +0.5 # here\n   \n"
        "3;30;0;0;0;0;1e-3");
    ASSERT_EQ(poses.size(), 3U);
    EXPECT_EQ(poses[2].vehicleInMap.x, 30);
    EXPECT_NEAR(poses[1].vehicleInMap.roll, 0.5, rounding);
}

TEST_F(TrajectoryFile, wrongCountsNameTheLine) {
    EXPECT_THAT(errorOf("1 2 3 4 0 0 0\n# fine\n1 2 3 4\n"),
                AllOf(HasSubstr("run7.tum:3: 4 numbers, but it takes 7 or 8"), HasSubstr("qw")));
    EXPECT_THAT(errorOf("1 2 3 4 5 6 7 8 9\n"), HasSubstr("run7.tum:1: more than 8 numbers"));
}

TEST_F(TrajectoryFile, mixedFormatsAreRefused) {
    EXPECT_THAT(errorOf("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0\n"),
                HasSubstr("run7.tum:2: 7 numbers, but 8 before"));
}

TEST_F(TrajectoryFile, whatIsNoNumberIsRefused) {
    EXPECT_THAT(errorOf("time x y z yaw pitch roll\n"), HasSubstr(":1: 'time' is not a number"));
    EXPECT_THAT(errorOf("1 0 0 0 0 0 0x\n"), HasSubstr("'0x' is not a number"));
    EXPECT_THAT(errorOf("1 nan 0 0 0 0 0\n"), HasSubstr("'nan' is not finite"));
    EXPECT_THAT(errorOf("1 1e999 0 0 0 0 0\n"), HasSubstr("'1e999' is not a number"));
    EXPECT_THAT(errorOf(std::string("\x89\0CPose", 7)), HasSubstr("'??CPose' is not a number"));
}

TEST_F(TrajectoryFile, timesThatAreNoneAreRefused) {
    EXPECT_THAT(errorOf("-1 0 0 0 0 0 0\n"), HasSubstr("-1 is no time in seconds"));
    EXPECT_THAT(errorOf("1700000000000000000 0 0 0 0 0 0\n"), HasSubstr("no time in seconds"));
    EXPECT_THAT(errorOf("inf 0 0 0 0 0 0\n"), HasSubstr("'inf' is not finite"));
}

TEST_F(TrajectoryFile, quaternionsThatAreNoneAreRefused) {
    EXPECT_THAT(errorOf("1 0 0 0 0 0 0 0\n"), HasSubstr("length of 0, not 1"));
    EXPECT_THAT(errorOf("1 0 0 0 0 0 0 1.03\n"), HasSubstr("length of 1.03, not 1"));
    EXPECT_EQ(read("1 0 0 0 0 0 0.71 0.71\n").size(), 1U);  // two decimals
}

TEST_F(TrajectoryFile, degreesAreNoticed) {
    EXPECT_THAT(errorOf("1 0 0 0 90 0 0\n"), HasSubstr("90 is more than a full turn in radians"));
}

TEST_F(TrajectoryFile, fileWithoutPosesIsRefused) {
    EXPECT_THAT(errorOf(""), HasSubstr("run7.tum holds no pose"));
    EXPECT_THAT(errorOf("# t x y z yaw pitch roll\n"), HasSubstr("holds no pose"));
}

TEST_F(TrajectoryFile, fileThatCannotBeReadIsNamed) {
    EXPECT_THROW(readTrajectory(folder_ / "none.tum", 0, 0), std::runtime_error);
    EXPECT_THROW(readTrajectory(folder_.path(), 0, 0), std::runtime_error);
}

}  // namespace
}  // namespace offmap::rawlog
