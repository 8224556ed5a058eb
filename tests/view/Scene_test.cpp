// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>
#include <offmap/view/Scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace offmap::view {
namespace {

// Ends 90 degrees apart at x = 1.41 m; the middle bulges out to 2 m, of which pieces of 0.1 rad
// leave out 2 (1 - cos 0.05) = 2.5 mm.
TEST(Scene, bentWallsBulge) {
    const double quarter = std::numbers::pi / 2;
    const core::LineMap map(core::wallsAlong({{0, 0}, 2, -quarter / 2, quarter}, {}));
    const mrpt::math::TBoundingBox extent({-5, -5, 0}, {5, 5, 3});
    const auto walls = sceneOf({}, map, extent, {})->getByName("walls");
    ASSERT_TRUE(walls);
    const auto box = walls->getBoundingBox();
    EXPECT_NEAR(box.min.x, std::sqrt(2.0), 1e-6) << "single precision";
    EXPECT_NEAR(box.max.x, 2, 0.0026);
    EXPECT_NEAR(box.max.y, std::sqrt(2.0), 1e-6);
    EXPECT_EQ(box.max.z, 3);
}

}  // namespace
}  // namespace offmap::view
