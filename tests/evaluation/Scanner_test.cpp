// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Scanner.h>

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace offmap::evaluation {

namespace {

void expectOneClockwiseTurn(const Scanner& scanner) {
    const auto& azimuths = scanner.azimuths;
    EXPECT_DOUBLE_EQ(azimuths.front(), std::numbers::pi);
    EXPECT_GT(azimuths.back(), -std::numbers::pi);
    EXPECT_TRUE(std::ranges::is_sorted(azimuths, std::greater{}));
    EXPECT_TRUE(std::ranges::is_sorted(scanner.elevations));
    // the step over the end is as wide as the others
    const double step = azimuths[0] - azimuths[1];
    EXPECT_NEAR(azimuths.back() - step, -std::numbers::pi, 1e-12);
}

}  // namespace

TEST(Scanner, paperHasItsNumberOfBeams) {
    const Scanner scanner = paperScanner();
    EXPECT_EQ(scanner.azimuths.size() * scanner.elevations.size(), 32761u);
    EXPECT_DOUBLE_EQ(scanner.elevations.front(), -std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(scanner.elevations.back(), std::numbers::pi / 2);
    expectOneClockwiseTurn(scanner);
}

TEST(Scanner, vlp16HasRingsTwoDegreesApart) {
    const Scanner scanner = vlp16();
    EXPECT_EQ(scanner.azimuths.size(), 1800u);
    ASSERT_EQ(scanner.elevations.size(), 16u);
    for (size_t ring = 0; ring < 16; ++ring) {
        EXPECT_NEAR(scanner.elevations[ring], mrpt::DEG2RAD(-15 + 2.0 * double(ring)), 1e-15);
    }
    expectOneClockwiseTurn(scanner);
}

TEST(Scanner, denseHas128RingsAnd2048Columns) {
    const Scanner scanner = dense();
    EXPECT_EQ(scanner.azimuths.size(), 2048u);
    EXPECT_EQ(scanner.elevations.size(), 128u);
    expectOneClockwiseTurn(scanner);
}

}  // namespace offmap::evaluation
