// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/GaussianNoise.h>

#include <gtest/gtest.h>

#include <cmath>

namespace offmap::evaluation {

namespace {

constexpr int count = 200000;
/// A statistic may be off by 5 of its own standard deviations: 1 false alarm in 1.7 million.
constexpr double sigmas = 5;

}  // namespace

TEST(GaussianNoise, seedDeterminesTheNumbers) {
    GaussianNoise a(7), b(7), c(8);
    bool differ = false;
    for (int i = 0; i < 100; ++i) {
        const double number = a.next();
        EXPECT_EQ(number, b.next());
        differ |= number != c.next();
    }
    EXPECT_TRUE(differ);
}

TEST(GaussianNoise, sigmaScales) {
    GaussianNoise one(3), scaled(3);
    for (int i = 0; i < 100; ++i) EXPECT_DOUBLE_EQ(scaled.next(0.02), 0.02 * one.next());
}

TEST(GaussianNoise, momentsAreThoseOfTheNormalDistribution) {
    GaussianNoise noise(1);
    double sum = 0, squares = 0, fourth = 0, neighbours = 0, last = 0;
    for (int i = 0; i < count; ++i) {
        const double x = noise.next();
        sum += x;
        squares += x * x;
        fourth += x * x * x * x;
        neighbours += x * last;
        last = x;
    }
    // variances of x, x^2, x^4 and of x times an independent x: 1, 2, 96, 1
    EXPECT_NEAR(sum / count, 0, sigmas * std::sqrt(1.0 / count));
    EXPECT_NEAR(squares / count, 1, sigmas * std::sqrt(2.0 / count));
    EXPECT_NEAR(fourth / count, 3, sigmas * std::sqrt(96.0 / count));
    EXPECT_NEAR(neighbours / count, 0, sigmas * std::sqrt(1.0 / count));
}

TEST(GaussianNoise, shareWithinOneSigmaFits) {
    GaussianNoise noise(2);
    int within = 0;
    for (int i = 0; i < count; ++i) within += std::abs(noise.next()) < 1 ? 1 : 0;
    const double expected = std::erf(std::sqrt(0.5));
    EXPECT_NEAR(static_cast<double>(within) / count, expected,
                sigmas * std::sqrt(expected * (1 - expected) / count));
}

}  // namespace offmap::evaluation
