// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Movement.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>
#include <random>

namespace {

using mrpt::math::TPose3D;
using offmap::rawlog::Movement;

mrpt::Clock::time_point at(double seconds) { return mrpt::Clock::fromDouble(1.7e9 + seconds); }

/// Relative: stamps of 1.7e9 s are doubles with 2e-7 s, intervals are half a second.
constexpr double clockError = 1e-6;

TEST(Movement, withoutPosesThereIsNone) {
    const Movement movement;
    EXPECT_EQ(movement.distance(), 0);
    EXPECT_EQ(movement.meanSpeed(), std::nullopt);
}

TEST(Movement, onePoseTakesNoTime) {
    Movement movement;
    movement.add(at(0), {1, 2, 0, 0, 0, 0}, 0);
    EXPECT_EQ(movement.seconds(), 0);
    EXPECT_EQ(movement.meanSpeed(), std::nullopt);
}

TEST(Movement, straightDriveIsAsLongAndFastAsItIs) {
    Movement movement;
    // 2 m/s for 10 s; each pose is 0.2 m from the one before.
    for (int i = 0; i <= 100; ++i) movement.add(at(0.1 * i), {0.2 * i, 0, 0, 0, 0, 0}, 0.01);
    EXPECT_NEAR(movement.distance(), 20, 1e-9);
    EXPECT_NEAR(*movement.meanSpeed(), 2, 2 * clockError);
    EXPECT_NEAR(movement.maxSpeed(), 2, 2 * clockError);
    EXPECT_EQ(movement.maxTurnRate(), 0);
}

TEST(Movement, robotThatStandsTravelsNothingWhateverTheNoise) {
    constexpr double sigma = 0.05;  // [m]
    std::mt19937 random(1);
    // 2.1 sigma at most, in both axes: 3 sigma from pose to pose is not reached.
    std::uniform_real_distribution<double> noise(-sigma, sigma);
    Movement movement;
    for (int i = 0; i < 1000; ++i) {
        movement.add(at(0.1 * i), {noise(random), noise(random), 0, 0, 0, 0}, sigma);
    }
    EXPECT_EQ(movement.distance(), 0);
}

TEST(Movement, turnRateIsOfTheShorterWay) {
    Movement movement;
    movement.add(at(0), {0, 0, 0, mrpt::DEG2RAD(170.0), 0, 0}, 0);
    movement.add(at(1), {0, 0, 0, mrpt::DEG2RAD(-170.0), 0, 0}, 0);
    EXPECT_NEAR(movement.maxTurnRate(), mrpt::DEG2RAD(20.0), clockError);
}

TEST(Movement, speedIsTakenOverHalfASecond) {
    Movement movement;
    movement.add(at(0), {}, 0);
    movement.add(at(0.01), {0.1, 0, 0, 0, 0, 0}, 0);  // a jump of 10 m/s, gone at once
    movement.add(at(0.5), {}, 0);
    EXPECT_EQ(movement.maxSpeed(), 0);
}

TEST(Movement, timesThatRunBackDoNoHarm) {
    Movement movement;
    movement.add(at(5), {}, 0);
    movement.add(at(0), {1, 0, 0, 0, 0, 0}, 0);
    EXPECT_EQ(movement.seconds(), 0);
    EXPECT_EQ(movement.maxSpeed(), 0);
    EXPECT_EQ(movement.distance(), 1);
}

}  // namespace
