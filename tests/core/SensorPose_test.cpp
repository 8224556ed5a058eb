// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SensorPose.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

namespace offmap::core {

using mrpt::poses::CPose3D;
using mrpt::poses::CPose3DPDFGaussian;

namespace {

constexpr double rightAngle = std::numbers::pi / 2;

const CPose3D vehicle(3, -2, 0, 0.7, 0, 0);
const CPose3D mount(0.4, 0.25, 1.2, 0.3, 0, rightAngle);

Eigen::Matrix3d someCovariance() {
    Eigen::Matrix3d covariance;
    covariance << 25e-4, 5e-4, 2e-4,  //
        5e-4, 16e-4, -1e-4,           //
        2e-4, -1e-4, 3e-4;
    return covariance;
}

}  // namespace

TEST(ComposeOnGround, meanIsThatOfThePoses) {
    EXPECT_EQ(composeOnGround(vehicle, someCovariance(), mount).sensorInMap, vehicle + mount);
}

TEST(ComposeOnGround, leverTurnsHeadingIntoPositionHandSolved) {
    // The vehicle heads along x, the sensor 2 m ahead: a turn moves it sideways, 2 m per rad.
    Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.04, 0.0009).asDiagonal();
    const auto sensor =
        composeOnGround(CPose3D(5, 5, 0, 0, 0, 0), covariance, CPose3D(2, 0, 1, 0, 0, 0));
    Eigen::Matrix3d expected;
    expected << 0.01, 0, 0, 0, 0.04 + 4 * 0.0009, 2 * 0.0009, 0, 2 * 0.0009, 0.0009;
    EXPECT_TRUE(sensor.groundCovariance.isApprox(expected, 1e-15)) << sensor.groundCovariance;
}

TEST(ComposeOnGround, agreesWithMonteCarlo) {
    constexpr int samples = 200'000;
    const Eigen::Matrix3d covariance = someCovariance();
    const Eigen::Matrix3d root = covariance.llt().matrixL();
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const CPose3D mean = vehicle + mount;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int i = 0; i < samples; ++i) {
        const double a = normal(random), b = normal(random), c = normal(random);
        const Eigen::Vector3d error = root * Eigen::Vector3d(a, b, c);
        const CPose3D sensor = CPose3D(vehicle.x() + error(0), vehicle.y() + error(1), 0,
                                       vehicle.yaw() + error(2), 0, 0) +
                               mount;
        const Eigen::Vector3d e(sensor.x() - mean.x(), sensor.y() - mean.y(), error(2));
        sum += e * e.transpose();
    }
    const Eigen::Matrix3d expected = composeOnGround(vehicle, covariance, mount).groundCovariance;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            const double ofSampling = std::sqrt(
                (expected(r, r) * expected(c, c) + expected(r, c) * expected(r, c)) / samples);
            // A lever of 0.5 m on a curve: it is short by half a heading variance of its length.
            const double ofLinearising = 0.5 * 0.5 * covariance(2, 2) * covariance(2, 2);
            EXPECT_NEAR(sum(r, c) / samples, expected(r, c), 5 * ofSampling + ofLinearising)
                << r << ", " << c;
        }
    }
}

TEST(ComposeOnGround, headingVarianceStaysWhereEulerAnglesInflateIt) {
    // Near a pitch of 90 degrees a small roll or pitch of the vehicle turns the Euler yaw by its
    // tangent: 1e-4 rad^2 of either, through tan(86 deg) = 14.3, buries the 3e-4 rad^2 of yaw.
    const double pitch = mrpt::DEG2RAD(86.0);
    const CPose3D pitched(0.4, 0, 1.2, 0, pitch, 0);
    CPose3DPDFGaussian euler;
    euler.mean = vehicle;
    euler.cov.setZero();
    euler.cov(0, 0) = euler.cov(1, 1) = 25e-4;
    euler.cov(3, 3) = 3e-4;
    euler.cov(4, 4) = euler.cov(5, 5) = 1e-4;
    const Eigen::Matrix3d ground = groundBlock(euler.cov);
    euler += pitched;
    EXPECT_NEAR(euler.cov(3, 3), 3e-4 + 1e-4 * std::pow(std::tan(pitch), 2), 1e-9);
    EXPECT_GT(euler.cov(3, 3), 50 * 3e-4);
    EXPECT_DOUBLE_EQ(composeOnGround(vehicle, ground, pitched).groundCovariance(2, 2), 3e-4);
}

TEST(GroundBlock, picksXYAndYaw) {
    mrpt::math::CMatrixDouble66 covariance;
    for (int r = 0; r < 6; ++r) {
        for (int c = 0; c < 6; ++c) covariance(r, c) = 10 * r + c;
    }
    Eigen::Matrix3d expected;
    expected << 0, 1, 3, 10, 11, 13, 30, 31, 33;
    EXPECT_EQ(groundBlock(covariance), expected);
}

TEST(PositiveSemidefinite, acceptsWhatACovarianceMayBe) {
    EXPECT_TRUE(isPositiveSemidefinite(Eigen::Matrix3d::Zero()));
    EXPECT_TRUE(isPositiveSemidefinite(Eigen::MatrixXd::Identity(6, 6)));
    EXPECT_TRUE(isPositiveSemidefinite(someCovariance()));
    const Eigen::Vector3d v(0.1, -0.2, 0.03);
    EXPECT_TRUE(isPositiveSemidefinite(v * v.transpose()));  // of rank 1
    EXPECT_TRUE(isPositiveSemidefinite(someCovariance().cast<float>().cast<double>()));
}

TEST(PositiveSemidefinite, refusesWhatItMayNot) {
    Eigen::Matrix2d matrix;
    matrix << 1, 2, 2, 1;  // eigenvalues 3 and -1
    EXPECT_FALSE(isPositiveSemidefinite(matrix));
    EXPECT_FALSE(isPositiveSemidefinite(-1e-9 * Eigen::Matrix3d::Identity()));
    matrix << 1, 0.1, 0, 1;
    EXPECT_FALSE(isPositiveSemidefinite(matrix)) << "not symmetric";
    matrix << 1, 0, 0, -1e-3;
    EXPECT_FALSE(isPositiveSemidefinite(matrix));
    EXPECT_FALSE(isPositiveSemidefinite(Eigen::MatrixXd::Zero(2, 3)));
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        matrix << 1, 0, 0, bad;
        EXPECT_FALSE(isPositiveSemidefinite(matrix));
        matrix << 1, bad, bad, 1;
        EXPECT_FALSE(isPositiveSemidefinite(matrix));
    }
}

TEST(PoseFault, namesAreStableAndDistinct) {
    std::set<std::string_view> names;
    for (const PoseFault fault : {PoseFault::NoPose, PoseFault::TooOld, PoseFault::NotFinite,
                                  PoseFault::NotPsd, PoseFault::TooUncertain, PoseFault::OffMap}) {
        names.insert(toString(fault));
    }
    EXPECT_EQ(names, (std::set<std::string_view>{"no_pose", "pose_too_old", "pose_not_finite",
                                                 "covariance_not_psd", "pose_too_uncertain",
                                                 "no_wall_in_range"}));
}

}  // namespace offmap::core
