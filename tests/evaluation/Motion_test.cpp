// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Motion.h>

#include <gtest/gtest.h>

#include <numbers>

namespace offmap::evaluation {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-14;  // of sums and sines of numbers around 1

void expectNear(const mrpt::math::TPose2D& a, const mrpt::math::TPose2D& b) {
    EXPECT_NEAR(a.x, b.x, rounding);
    EXPECT_NEAR(a.y, b.y, rounding);
    EXPECT_NEAR(a.phi, b.phi, rounding);
}

}  // namespace

TEST(Motion, withoutTurningGoesStraight) {
    expectNear(moved({1, 2, pi / 2}, {0.5, 0}, 4), {1, 4, pi / 2});
}

TEST(Motion, quarterTurnIsAQuarterOfACircle) {
    // radius speed / yaw rate = 1
    expectNear(moved({0, 0, 0}, {pi / 2, pi / 2}, 1), {1, 1, pi / 2});
    expectNear(moved({0, 0, 0}, {pi / 2, -pi / 2}, 1), {1, -1, -pi / 2});
}

TEST(Motion, withoutSpeedTurnsOnTheSpot) {
    expectNear(moved({3, 4, 0.1}, {0, 0.2}, 2), {3, 4, 0.5});
}

TEST(Motion, inTwoPartsIsTheSame) {
    const Motion motion{0.7, -0.4};
    const auto whole = moved({1, -1, 3}, motion, 2.5);
    expectNear(moved(moved({1, -1, 3}, motion, 1.1), motion, 1.4), whole);
}

}  // namespace offmap::evaluation
