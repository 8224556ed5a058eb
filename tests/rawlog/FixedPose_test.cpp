// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/FixedPose.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using offmap::rawlog::FixedPose;

TEST(FixedPose, isTheSameAtAnyTime) {
    const FixedPose pose({1.0, -2.0, 0.5}, 0.1, 0.02);
    for (const mrpt::Clock::time_point time : {mrpt::Clock::time_point(), mrpt::Clock::now()}) {
        const auto lookup = pose.at(time);
        ASSERT_TRUE(lookup.vehicleInMap);
        EXPECT_EQ(*lookup.vehicleInMap, mrpt::poses::CPose3D(1.0, -2.0, 0.0, 0.5, 0.0, 0.0));
        const Eigen::Vector3d variances(0.1 * 0.1, 0.1 * 0.1, 0.02 * 0.02);
        EXPECT_EQ(lookup.groundCovariance, Eigen::Matrix3d(variances.asDiagonal()));
    }
}

TEST(FixedPose, refusesWhatIsNoPose) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(FixedPose({nan, 0, 0}, 0.1, 0.1), std::invalid_argument);
    EXPECT_THROW(FixedPose({0, infinity, 0}, 0.1, 0.1), std::invalid_argument);
    EXPECT_THROW(FixedPose({0, 0, nan}, 0.1, 0.1), std::invalid_argument);
    EXPECT_THROW(FixedPose({0, 0, 0}, -0.1, 0.1), std::invalid_argument);
    EXPECT_THROW(FixedPose({0, 0, 0}, 0.1, nan), std::invalid_argument);
}

}  // namespace
