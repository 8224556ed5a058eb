// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/FixedPose.h>

#include <gtest/gtest.h>
#include <mrpt/poses/CPosePDFGaussian.h>

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

TEST(FixedPose, takesAnEstimateWithItsCovariance) {
    mrpt::math::CMatrixDouble33 covariance;
    covariance.asEigen() << 0.04, 0.01, 0.002, 0.01, 0.09, 0.003, 0.002, 0.003, 0.0025;
    const mrpt::poses::CPosePDFGaussian inThePlane({1.0, -2.0, 0.5}, covariance);
    const auto lookup = FixedPose(mrpt::poses::CPose3DPDFGaussian(inThePlane)).at({});
    ASSERT_TRUE(lookup.vehicleInMap);
    EXPECT_EQ(*lookup.vehicleInMap, mrpt::poses::CPose3D(1.0, -2.0, 0.0, 0.5, 0.0, 0.0));
    EXPECT_EQ(lookup.groundCovariance, Eigen::Matrix3d(covariance.asEigen()));
}

TEST(FixedPose, faultyEstimateGivesItsFault) {
    mrpt::poses::CPose3DPDFGaussian estimate;
    estimate.cov.setIdentity();
    estimate.cov(0, 1) = estimate.cov(1, 0) = 2;  // |covariance| above both variances
    EXPECT_FALSE(FixedPose(estimate).at({}).vehicleInMap);
    EXPECT_EQ(FixedPose(estimate).at({}).fault, offmap::core::PoseFault::NotPsd);
    estimate.cov(0, 1) = estimate.cov(1, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(FixedPose(estimate).at({}).fault, offmap::core::PoseFault::NotFinite);
}

}  // namespace
