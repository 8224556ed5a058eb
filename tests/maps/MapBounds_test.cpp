// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>
#include <offmap/maps/MapBounds.h>

#include <gtest/gtest.h>

#include <numbers>

namespace offmap::maps {
namespace {

TEST(MapBounds, holdAllWallsAndTheBellyOfAnArc) {
    std::vector<core::Wall> walls = core::wallsAlong({{1, 0}, 2, 0, std::numbers::pi}, {});
    walls.push_back({{{-3, -4}, {0, 0}}});
    const core::WallBounds bounds = boundsOfAll(walls);
    EXPECT_NEAR(bounds.low.x, -3, 1e-12);
    EXPECT_NEAR(bounds.low.y, -4, 1e-12);
    EXPECT_NEAR(bounds.high.x, 3, 1e-12);
    EXPECT_NEAR(bounds.high.y, 2, 1e-12);
}

}  // namespace
}  // namespace offmap::maps
