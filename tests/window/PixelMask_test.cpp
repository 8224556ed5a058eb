// SPDX-License-Identifier: BSD-3-Clause
#include "PixelMask.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace offmap::window {

namespace {

bool coveredAt(const PixelMask& mask, int x, int y) {
    return mask.covered()[static_cast<size_t>(y * mask.width() + x)] == 255;
}

long count(const PixelMask& mask) {
    return std::count(mask.covered().begin(), mask.covered().end(), uint8_t{255});
}

}  // namespace

TEST(PixelMask, aDotIsASquare) {
    PixelMask mask(10, 8);
    mask.dot({3.7, 2.2}, 2);
    EXPECT_EQ(count(mask), 4);
    EXPECT_TRUE(coveredAt(mask, 3, 2));
    EXPECT_TRUE(coveredAt(mask, 4, 3));
}

TEST(PixelMask, dotsOutsideAreLeftOutAndCutAtTheEdge) {
    PixelMask mask(10, 8);
    mask.dot({-0.1, 2}, 2);
    mask.dot({10, 2}, 2);
    mask.dot({1e300, -1e300}, 2);
    EXPECT_TRUE(mask.empty());
    mask.dot({9.5, 7.5}, 2);
    EXPECT_EQ(count(mask), 1);
}

TEST(PixelMask, aLineHasNoHoles) {
    PixelMask mask(10, 8);
    mask.line({0.5, 1.5}, {9.5, 4.5});
    for (int x = 0; x < 10; ++x) {
        bool any = false;
        for (int y = 0; y < 8; ++y) any = any || coveredAt(mask, x, y);
        EXPECT_TRUE(any) << x;
    }
    EXPECT_TRUE(coveredAt(mask, 0, 1));
    EXPECT_TRUE(coveredAt(mask, 9, 4));
}

TEST(PixelMask, aLineShorterThanAPixelIsSeen) {
    PixelMask mask(10, 8);
    mask.line({3.2, 3.2}, {3.3, 3.2});
    EXPECT_EQ(count(mask), 1);
}

TEST(PixelMask, aLineAlongTheOuterEdgeIsLeftOut) {
    PixelMask mask(10, 8);
    mask.line({0, 8}, {10, 8});
    EXPECT_TRUE(mask.empty());
}

}  // namespace offmap::window
