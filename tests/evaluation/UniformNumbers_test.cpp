// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/UniformNumbers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

constexpr int count = 100000;
/// A statistic may be off by 5 of its own standard deviations: 1 false alarm in 1.7 million.
constexpr double sigmas = 5;

}  // namespace

TEST(UniformNumbers, seedDeterminesTheNumbers) {
    UniformNumbers a(7), b(7), c(8);
    EXPECT_EQ(a.between(0, 1), b.between(0, 1));
    EXPECT_NE(a.between(0, 1), c.between(0, 1));
}

TEST(UniformNumbers, firstNumberIsThatOfTheStandardGenerator) {
    // the 10000th number of a default mt19937_64 (seed 5489) is 9981545732273789042 by the standard
    UniformNumbers random(5489);
    double last = 0;
    for (int i = 0; i < 10000; ++i) last = random.between(0, 1);
    EXPECT_EQ(last, std::floor(9981545732273789042.0L / 2048) / 0x1p53);
}

TEST(UniformNumbers, meanAndVarianceAreThoseOfTheInterval) {
    UniformNumbers random(1);
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i) {
        const double x = random.between(-1, 3);
        ASSERT_TRUE(x >= -1 && x < 3);
        sum += x - 1;
        squares += (x - 1) * (x - 1);
    }
    // width 4: variance 16 / 12; of the squares 4^4 / 80 - (16 / 12)^2
    EXPECT_NEAR(sum / count, 0, sigmas * std::sqrt(16.0 / 12 / count));
    EXPECT_NEAR(squares / count, 16.0 / 12, sigmas * std::sqrt((256.0 / 80 - 256.0 / 144) / count));
}

TEST(UniformNumbers, everyChoiceIsEquallyOften) {
    UniformNumbers random(2);
    std::array<int, 5> counts{};
    for (int i = 0; i < count; ++i) ++counts.at(random.below(counts.size()));
    for (const int n : counts) {
        EXPECT_NEAR(n, count / 5, sigmas * std::sqrt(count * 0.2 * 0.8));
    }
}

TEST(UniformNumbers, choiceFromNothingIsRefused) {
    UniformNumbers random(1);
    EXPECT_THROW(random.below(0), std::invalid_argument);
}

}  // namespace offmap::evaluation
