// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SimulatedScan.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// The statistics of what simulate() and drawEstimate() draw.

namespace offmap::evaluation {

namespace {

using mrpt::poses::CPose3D;

constexpr size_t count = 20000;
/// A statistic may be off by 5 of its own standard deviations: 1 false alarm in 1.7 million.
constexpr double sigmas = 5;

/// Ranges measured to a wall at x = 3 by beams of one elevation.
std::vector<double> rangesToWall(double elevation, const ScannerNoise& noise) {
    World world;
    world.addPanel({{{3, -1000}, {3, 1000}}, {-1000, 1000}});
    const Scanner scanner{std::vector<double>(count, 0.0), {elevation}, 1000, 1};
    std::vector<double> ranges;
    for (const auto& point : simulate(world, scanner, {}, noise, 3).scan.points) {
        ranges.push_back(point.cast<double>().norm());
    }
    return ranges;
}

/// That the numbers have this mean and standard deviation. \param bias what they may be off besides
void expectNormal(const std::vector<double>& numbers, double mean, double sigma, double bias) {
    ASSERT_EQ(numbers.size(), count);
    double sum = 0, squares = 0;
    for (const double x : numbers) {
        sum += x - mean;
        squares += (x - mean) * (x - mean);
    }
    const double n = static_cast<double>(count);
    EXPECT_NEAR(sum / n, 0, sigmas * sigma / std::sqrt(n) + bias);
    EXPECT_NEAR(std::sqrt(squares / n) / sigma, 1, sigmas / std::sqrt(2 * n) + bias / sigma);
}

}  // namespace

TEST(SimulatedNoise, rangeNoiseAddsToTheRange) {
    // single precision rounds 3.5 m by 2e-7 m
    expectNormal(rangesToWall(0.5, {.range = 0.02}), 3 / std::cos(0.5), 0.02, 1e-6);
}

TEST(SimulatedNoise, angleNoiseShiftsTheRangeByItsSlope) {
    // r = 3 / cos(e), dr/de = r tan(e) = 8.7 m, d2r/de2 = r (1 + 2 tan^2(e)) = 34 m;
    // the azimuth acts in second order only, by r = 5.6 m: bias (34 + 6) / 2 * 1e-8 m = 2e-7 m
    const double elevation = 1.0, sigma = 1e-4, range = 3 / std::cos(elevation);
    expectNormal(rangesToWall(elevation, {.angle = sigma}), range,
                 range * std::tan(elevation) * sigma, 1e-6);
}

TEST(SimulatedNoise, angleNoiseLeavesTheDirectionInTheScan) {
    World world;
    world.addPanel({{{3, -1000}, {3, 1000}}, {-1000, 1000}});
    const Scanner scanner{{0.4}, {-0.2, 0.5}, 1000, 1};
    const auto [scan, truth] = simulate(world, scanner, {}, {.angle = 0.05}, 3);
    ASSERT_EQ(scan.points.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        const auto& p = scan.points[i];
        EXPECT_NEAR(std::atan2(p.y, p.x), 0.4, 1e-6);  // a few roundings of single precision
        EXPECT_NEAR(std::asin(p.z / p.norm()), scanner.elevations[i], 1e-6);
        EXPECT_GT(std::abs(p.x - 3), 1e-4);  // the range is that of another beam
    }
}

TEST(DrawEstimate, errorsHaveTheCovariance) {
    core::SensorPose truth{.sensorInMap = CPose3D(5, -3, 0.6, 0.4, 0.02, -0.03)};
    truth.groundCovariance << 0.04, 0.01, 0.001, 0.01, 0.09, -0.002, 0.001, -0.002, 0.0025;
    GaussianNoise noise(4);
    Eigen::Matrix3d measured = Eigen::Matrix3d::Zero();
    for (size_t i = 0; i < count; ++i) {
        const CPose3D estimate = drawEstimate(truth, noise).sensorInMap;
        const CPose3D& mean = truth.sensorInMap;
        const Eigen::Vector3d error(estimate.x() - mean.x(), estimate.y() - mean.y(),
                                    estimate.yaw() - mean.yaw());
        measured += error * error.transpose() / static_cast<double>(count);
    }
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            // variance of a product of two normal errors: S_rr S_cc + S_rc^2
            const auto& s = truth.groundCovariance;
            const double variance = s(r, r) * s(c, c) + s(r, c) * s(r, c);
            EXPECT_NEAR(measured(r, c), s(r, c), sigmas * std::sqrt(variance / double(count)));
        }
    }
}

TEST(DrawEstimate, onlyHeadingAndPlaceOnTheGroundAreOff) {
    core::SensorPose truth{.sensorInMap = CPose3D(5, -3, 0.6, 0.4, 0.02, -0.03)};
    truth.groundCovariance.diagonal() << 0.01, 0.01, 0.01;
    GaussianNoise noise(4);
    const core::SensorPose estimate = drawEstimate(truth, noise);
    EXPECT_DOUBLE_EQ(estimate.sensorInMap.z(), 0.6);
    EXPECT_NEAR(estimate.sensorInMap.pitch(), 0.02, 1e-15);
    EXPECT_NEAR(estimate.sensorInMap.roll(), -0.03, 1e-15);
    EXPECT_NE(estimate.sensorInMap.yaw(), 0.4);
    EXPECT_EQ(estimate.groundCovariance, truth.groundCovariance);
}

TEST(DrawEstimate, withoutCovarianceItIsTheTruth) {
    const core::SensorPose truth{.sensorInMap = CPose3D(5, -3, 0.6, 0.4, 0, 0)};
    GaussianNoise noise(4);
    EXPECT_EQ(drawEstimate(truth, noise).sensorInMap.asTPose(), truth.sensorInMap.asTPose());
}

}  // namespace offmap::evaluation
