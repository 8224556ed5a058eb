// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallInformation.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <vector>

namespace offmap::core {

namespace {

struct Sample {
    Vector5 gradient;
    double share, distance, weight;
};

std::vector<Sample> samples() {
    std::vector<Sample> all;
    for (int i = 0; i < 7; ++i) {
        Vector5 gradient;
        gradient << 0.8, 0.6, 0.3 * i - 1, 0.1 * (i % 3), 0.05 * i;
        all.push_back({gradient, i / 6.0, 0.01 * (i % 4) - 0.02, 100.0 + 10 * i});
    }
    return all;
}

}  // namespace

// The oracle solves for pose and both ends together and takes the pose's block.
TEST(WallInformation, marginalisesWhatTheJointProblemDoes) {
    constexpr double sigma = 0.03;
    Eigen::Matrix<double, 7, 7> joint = Eigen::Matrix<double, 7, 7>::Zero();
    Eigen::Matrix<double, 7, 1> jointSlope = Eigen::Matrix<double, 7, 1>::Zero();
    joint(5, 5) = joint(6, 6) = 1 / (sigma * sigma);
    const Matrix5 prior = Matrix5::Identity();
    joint.topLeftCorner<5, 5>() = prior;
    WallInformation wall;
    for (const Sample& s : samples()) {
        Eigen::Matrix<double, 7, 1> gradient;
        gradient << s.gradient, 1 - s.share, s.share;
        joint += s.weight * gradient * gradient.transpose();
        jointSlope += s.weight * s.distance * gradient;
        wall.add(s.gradient, s.share, s.distance, s.weight);
    }
    Matrix5 information = prior;
    Vector5 slope = Vector5::Zero();
    wall.marginalise(sigma, information, slope);
    const Eigen::Matrix<double, 7, 7> covariance = joint.inverse();
    EXPECT_TRUE(information.inverse().isApprox(covariance.topLeftCorner<5, 5>(), 1e-9));
    const Vector5 solved = information.ldlt().solve(slope);
    EXPECT_TRUE(solved.isApprox((covariance * jointSlope).head<5>(), 1e-9));
}

// However many sights: a wall known to 3 cm tells the position across it to no better than that
// at its middle, sigma / sqrt(2) of two independent ends.
TEST(WallInformation, manySightsAreNoBetterThanTheMap) {
    constexpr double sigma = 0.03;
    WallInformation wall;
    Vector5 across = Vector5::Zero();
    across[1] = 1;
    constexpr int sights = 1'000;
    constexpr double weight = 1e4;  // of a sight good to 1 cm
    for (int i = 0; i < sights; ++i) wall.add(across, 0.5, 0, weight);
    Matrix5 information = Matrix5::Identity() * 1e-9;
    Vector5 slope = Vector5::Zero();
    wall.marginalise(sigma, information, slope);
    EXPECT_NEAR(1 / information(1, 1), sigma * sigma / 2 + 1 / (sights * weight), 1e-9);
}

}  // namespace offmap::core
