// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Disturbances.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::poses::CPose3D;

constexpr double pi = std::numbers::pi;
/// A handful of roundings at coordinates below 10 m.
constexpr double rounding = 1e-14;

core::SensorPose anyPose() { return {.sensorInMap = CPose3D(5, -3, 0.6, 0.4, 0.02, -0.03)}; }

mrpt::math::TPoint3D upwards(const core::SensorPose& sensor) {
    return sensor.sensorInMap.rotateVector({0, 0, 1});
}

}  // namespace

TEST(WithMapError, endsAreOffBySigma) {
    constexpr int count = 5000;
    std::vector<core::Wall> walls;
    for (int i = 0; i < count; ++i) walls.push_back({.line = {{1.0 * i, 0}, {1.0 * i, 5}}});
    GaussianNoise noise(1);
    const auto surveyed = withMapError(walls, 0.02, noise);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < count; ++i) {
        EXPECT_EQ(surveyed[i].sigma, 0.02);
        const auto first = surveyed[i].line.point1 - walls[i].line.point1;
        const auto second = surveyed[i].line.point2 - walls[i].line.point2;
        for (const double error : {first.x, first.y, second.x, second.y}) {
            sum += error;
            squares += error * error;
        }
    }
    // 5 standard deviations of mean and of sample deviation
    const double n = 4.0 * count;
    EXPECT_NEAR(sum / n, 0, 5 * 0.02 / std::sqrt(n));
    EXPECT_NEAR(std::sqrt(squares / n), 0.02, 5 * 0.02 / std::sqrt(2 * n));
}

TEST(WithMapError, cornersStayClosed) {
    GaussianNoise noise(1);
    const auto room = withMapError(
        {{.line = {{0, 0}, {4, 0}}}, {.line = {{4, 0}, {4, 3}}}, {.line = {{0, 0}, {4, 3}}}}, 0.05,
        noise);
    EXPECT_EQ(room[0].line.point2, room[1].line.point1);
    EXPECT_EQ(room[1].line.point2, room[2].line.point2);
    EXPECT_EQ(room[0].line.point1, room[2].line.point1);
    EXPECT_NE(room[0].line.point1, mrpt::math::TPoint2D(0, 0));
}

TEST(WithMapError, ofNoneLeavesTheLines) {
    GaussianNoise noise(1);
    const auto wall = withMapError({{.line = {{0, 1}, {4, 2}}}}, 0, noise).front();
    EXPECT_EQ(wall.line.point1, mrpt::math::TPoint2D(0, 1));
    EXPECT_EQ(wall.sigma, 0);
}

TEST(WithMapError, negativeSigmaIsRefused) {
    GaussianNoise noise(1);
    EXPECT_THROW(withMapError({}, -0.01, noise), std::invalid_argument);
    EXPECT_THROW(withMapError({}, std::nan(""), noise), std::invalid_argument);
}

TEST(Tilted, aheadIsPitchAndLeftIsNegativeRoll) {
    const CPose3D ahead = tilted({}, 0.03, 0).sensorInMap;
    EXPECT_NEAR(ahead.pitch(), 0.03, rounding);
    EXPECT_NEAR(ahead.roll(), 0, rounding);
    const CPose3D left = tilted({}, 0.03, pi / 2).sensorInMap;
    EXPECT_NEAR(left.roll(), -0.03, rounding);
    EXPECT_NEAR(left.pitch(), 0, rounding);
}

TEST(Tilted, axisLeansByTheTiltTowardsTheDirection) {
    for (const double direction : {-2.0, 0.3, 3.0}) {
        const auto up =
            upwards(tilted({.sensorInMap = CPose3D(1, 2, 3, 0.7, 0, 0)}, 0.2, direction));
        EXPECT_NEAR(std::acos(up.z), 0.2, 100 * rounding);  // acos loses digits near 0
        EXPECT_NEAR(std::remainder(std::atan2(up.y, up.x) - 0.7 - direction, 2 * pi), 0,
                    100 * rounding);
    }
    const CPose3D place = tilted(anyPose(), 0.2, 1).sensorInMap;
    EXPECT_EQ(place.translation(), anyPose().sensorInMap.translation());
}

TEST(WithStatedSigma, factorIsOfTheDeviations) {
    core::SensorPose truth = anyPose();
    truth.groundCovariance.diagonal() << 0.04, 0.01, 0.0025;
    const core::SensorPose timid = withStatedSigma(truth, 0.5);
    EXPECT_EQ(timid.groundCovariance, 0.25 * truth.groundCovariance);
    EXPECT_EQ(timid.sensorInMap, truth.sensorInMap);
    EXPECT_THROW(withStatedSigma(truth, -1), std::invalid_argument);
    EXPECT_THROW(withStatedSigma(truth, std::numeric_limits<double>::infinity()),
                 std::invalid_argument);
}

TEST(Misplaced, isOffByTheShiftAndTheTurnAlone) {
    const CPose3D truth = anyPose().sensorInMap;
    const CPose3D wrong = misplaced(anyPose(), 0.5, pi / 2, -0.2).sensorInMap;
    EXPECT_NEAR(wrong.x(), truth.x(), rounding);
    EXPECT_NEAR(wrong.y(), truth.y() + 0.5, rounding);
    EXPECT_EQ(wrong.z(), truth.z());
    EXPECT_NEAR(wrong.yaw(), truth.yaw() - 0.2, rounding);
    EXPECT_NEAR(wrong.pitch(), truth.pitch(), rounding);
    EXPECT_NEAR(wrong.roll(), truth.roll(), rounding);
}

}  // namespace offmap::evaluation
