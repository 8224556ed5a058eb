// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Picking.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace offmap::view {
namespace {

using mrpt::math::TPoint3D;

PlacedReturns returnsAt(const std::vector<mrpt::math::TPoint3Df>& points) {
    PlacedReturns returns;
    returns.points = points;
    returns.labels.assign(points.size(), core::PointLabel::Kept);
    return returns;
}

// Of the three within 0.01 rad of the x axis the second is nearest; the first is nearer still, but
// 0.02 rad off.
TEST(Picking, nearestWithinTheConeIsPicked) {
    const auto returns = returnsAt({{1, 0.02F, 0}, {2, 0.01F, 0}, {3, 0, 0}, {4, 0, 0.03F}});
    const ViewRay ray{{0, 0, 0}, {5, 0, 0}, 0.01};
    EXPECT_EQ(pick(returns, ray), 1U);
}

TEST(Picking, parallelBeamsDoNotWiden) {
    const auto returns = returnsAt({{2, 0.04F, 0}, {8, 0.04F, 0}, {9, 0.02F, 0}});
    EXPECT_EQ(pick(returns, {{0, 0, 0}, {1, 0, 0}, 0, 0.03}), 2U);
    EXPECT_EQ(pick(returns, {{0, 0, 0}, {1, 0, 0}, 0.006, 0}), 1U) << "0.04 m at 8 m, not at 2 m";
}

TEST(Picking, whatIsHiddenIsSeenThrough) {
    const auto returns = returnsAt({{1, 0, 0}, {2, 0, 0}});
    const ViewRay ray{{0, 0, 0}, {1, 0, 0}, 0.01};
    EXPECT_EQ(pick(returns, ray, std::vector<uint8_t>{1, 0}), 1U);
    EXPECT_EQ(pick(returns, ray, std::vector<uint8_t>{1, 1}), std::nullopt);
}

TEST(Picking, nothingIsBehindTheEyeNorAtPlacesThatAreNone) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto returns = returnsAt({{-1, 0, 0}, {nan, 0, 0}, {1, nan, 0}, {0, 0, 0}});
    EXPECT_EQ(pick(returns, {{0, 0, 0}, {1, 0, 0}, 0.5}), std::nullopt);
    EXPECT_EQ(pick({}, {{0, 0, 0}, {1, 0, 0}, 0.5}), std::nullopt);
}

TEST(Picking, rayWithoutDirectionIsRefused) {
    EXPECT_THROW(pick({}, {{0, 0, 0}, {0, 0, 0}, 0.1}), std::invalid_argument);
    const auto returns = returnsAt({{1, 0, 0}});
    EXPECT_THROW(pick(returns, {{0, 0, 0}, {1, 0, 0}, 0.1}, std::vector<uint8_t>{0, 0}),
                 std::invalid_argument);
}

// The angle between ray and return, by its cosine: no tangent, no projection. Rounding decides
// only within 1e-9 rad of the rim, where none of 50 x 2000 returns chances to be.
TEST(Picking, agreesWithTheAngleToEachReturn) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-10, 10);
    int picked = 0;
    for (int turn = 0; turn < 50; ++turn) {
        PlacedReturns returns;
        for (int i = 0; i < 2000; ++i) {
            returns.points.emplace_back(place(random), place(random), place(random));
        }
        const ViewRay ray{{1, 2, 3}, {place(random), place(random), place(random)}, 0.05};
        std::optional<size_t> nearest;
        double least = 1e9;
        for (size_t i = 0; i < returns.points.size(); ++i) {
            const TPoint3D p = TPoint3D(returns.points[i]) - ray.origin;
            const TPoint3D d = ray.direction * (1 / ray.direction.norm());
            const double depth = p.x * d.x + p.y * d.y + p.z * d.z;
            if (std::acos(depth / p.norm()) > ray.angle || depth >= least) continue;
            least = depth;
            nearest = i;
        }
        EXPECT_EQ(pick(returns, ray), nearest);
        picked += nearest ? 1 : 0;
    }
    // A cone of 0.05 rad holds 0.06 % of all directions: mostly a return or more of 2000.
    EXPECT_GT(picked, 20);
}

}  // namespace
}  // namespace offmap::view
