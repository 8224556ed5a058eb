// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double maxRange = 100;
constexpr double pi = std::numbers::pi;

Wall wall(const TPoint2D& from, const TPoint2D& to, double sigma = 0.03,
          const Interval& height = Interval::everything()) {
    return {{from, to}, sigma, height};
}

TPoint2D towards(double angle) { return {std::cos(angle), std::sin(angle)}; }

std::string messageOf(std::vector<Wall> walls) {
    try {
        LineMap map(std::move(walls));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(LineMap, badWallIsNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const Wall good = wall({0, 0}, {1, 0});
    EXPECT_EQ(messageOf({good}), "");
    EXPECT_EQ(messageOf({good, wall({nan, 0}, {1, 0})}),
              "wall 1 has an end point that is not finite");
    EXPECT_EQ(messageOf({wall({0, 0}, {1, -inf})}), "wall 0 has an end point that is not finite");
    EXPECT_EQ(messageOf({good, good, wall({3, 4}, {3, 4})}), "wall 2 has no length");
    EXPECT_EQ(messageOf({wall({0, 0}, {1, 0}, -0.01)}), "wall 0 has a sigma that is not >= 0");
    EXPECT_EQ(messageOf({wall({0, 0}, {1, 0}, nan)}), "wall 0 has a sigma that is not >= 0");
    EXPECT_EQ(messageOf({wall({0, 0}, {1, 0}, inf)}), "wall 0 has a sigma that is not >= 0");
}

TEST(LineMap, emptyMapHasNothing) {
    const LineMap map({});
    EXPECT_FALSE(map.castRay({0, 0}, {1, 0}, maxRange, 0));
    EXPECT_FALSE(map.nearestWall({0, 0}, maxRange, 0));
    EXPECT_FALSE(map.hasWallWithin({0, 0}, maxRange));
}

TEST(LineMap, movedMapAnswersAsBefore) {
    LineMap map({wall({2, -1}, {2, 1})});
    const LineMap moved = std::move(map);
    EXPECT_EQ(moved.castRay({0, 0}, {1, 0}, maxRange, 0)->range, 2);
}

TEST(CastRay, squareHitGivesRangeAndRightAngle) {
    const LineMap map({wall({2, -1}, {2, 1})});
    const auto hit = map.castRay({0, 0}, {1, 0}, maxRange, 0);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->range, 2);
    EXPECT_EQ(hit->wall, 0u);
    EXPECT_DOUBLE_EQ(hit->incidence.angle(), pi / 2);
}

TEST(CastRay, obliqueHitGivesItsAngleWhicheverWayTheWallIsDrawn) {
    for (const bool turned : {false, true}) {
        const TPoint2D a(2, -1), b(4, 1);
        const LineMap map({turned ? wall(b, a) : wall(a, b)});
        const auto hit = map.castRay({0, 0}, {1, 0}, maxRange, 0);
        ASSERT_TRUE(hit);
        EXPECT_DOUBLE_EQ(hit->range, 3);
        EXPECT_DOUBLE_EQ(hit->incidence.angle(), pi / 4);
    }
}

TEST(CastRay, missesWhatIsBesideBehindOrTooFar) {
    const LineMap map({wall({2, 1}, {2, 3}), wall({-1, -1}, {-1, 1}), wall({101, -1}, {101, 1})});
    EXPECT_FALSE(map.castRay({0, 0}, {1, 0}, maxRange, 0));
}

TEST(CastRay, firstOfSeveralWallsCounts) {
    const LineMap map({wall({9, -1}, {9, 1}), wall({3, -1}, {3, 1}), wall({5, -1}, {5, 1})});
    EXPECT_EQ(map.castRay({0, 0}, {1, 0}, maxRange, 0)->wall, 1u);
    EXPECT_EQ(map.castRay({4, 0}, {1, 0}, maxRange, 0)->wall, 2u);
    EXPECT_EQ(map.castRay({6, 0}, {1, 0}, maxRange, 0)->wall, 0u);
    EXPECT_EQ(map.castRay({6, 0}, {-1, 0}, maxRange, 0)->wall, 2u);
}

TEST(CastRay, maxRangeIsIncluded) {
    const LineMap map({wall({8, -1}, {8, 1})});
    EXPECT_TRUE(map.castRay({0, 0}, {1, 0}, 8, 0));
    EXPECT_FALSE(map.castRay({0, 0}, {1, 0}, std::nextafter(8.0, 0.0), 0));
    EXPECT_FALSE(map.castRay({0, 0}, {1, 0}, 1, 0));
}

TEST(CastRay, wallOfLimitedHeightIsSeenOnlyThere) {
    const LineMap map({wall({2, -1}, {2, 1}, 0.03, {1, 2}), wall({5, -1}, {5, 1})});
    EXPECT_EQ(map.castRay({0, 0}, {1, 0}, maxRange, 0.9)->wall, 1u);
    EXPECT_EQ(map.castRay({0, 0}, {1, 0}, maxRange, 1.0)->wall, 0u);
    EXPECT_EQ(map.castRay({0, 0}, {1, 0}, maxRange, 2.0)->wall, 0u);
    EXPECT_EQ(map.castRay({0, 0}, {1, 0}, maxRange, 2.1)->wall, 1u);
}

TEST(CastRay, endPointsBelongToTheWall) {
    const LineMap map({wall({2, 0}, {2, 1})});
    EXPECT_TRUE(map.castRay({0, 0}, {1, 0}, maxRange, 0));
    EXPECT_TRUE(map.castRay({0, 1}, {1, 0}, maxRange, 0));
    EXPECT_FALSE(map.castRay({0, -1e-9}, {1, 0}, maxRange, 0));
    EXPECT_FALSE(map.castRay({0, 1 + 1e-9}, {1, 0}, maxRange, 0));
}

TEST(CastRay, rayAlongAWallMeetsItsNearerEnd) {
    const LineMap map({wall({6, 0}, {3, 0}), wall({9, -1}, {9, 1})});
    const auto hit = map.castRay({0, 0}, {1, 0}, maxRange, 0);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->range, 3);
    EXPECT_EQ(hit->wall, 0u);
    EXPECT_GT(hit->incidence.angle(), 0);
    EXPECT_EQ(map.castRay({4, 0}, {1, 0}, maxRange, 0)->range, 0);  // stands on it
    EXPECT_EQ(map.castRay({7, 0}, {1, 0}, maxRange, 0)->wall, 1u);  // behind it
    EXPECT_EQ(map.castRay({0, 1e-9}, {1, 0}, maxRange, 0)->wall, 1u);
}

TEST(CastRay, originOnAWallIsAtRangeZero) {
    const LineMap map({wall({0, -1}, {0, 1})});
    EXPECT_EQ(map.castRay({0, 0.5}, {1, 0}, maxRange, 0)->range, 0);
}

TEST(CastRay, nothingLeaksThroughSharedEndPoints) {
    // Rays aimed at the corners of a polygon, from many places, must not slip out between its
    // walls, whatever rounding does to them.
    std::vector<TPoint2D> corners;
    for (int i = 0; i < 12; ++i) corners.push_back(towards(0.5236 * i) * (5 + i % 3));
    std::vector<Wall> walls;
    for (size_t i = 0; i < corners.size(); ++i) {
        walls.push_back(wall(corners[i], corners[(i + 1) % corners.size()]));
    }
    const LineMap map(std::move(walls));
    for (int i = 0; i < 400; ++i) {
        const TPoint2D origin = towards(0.7 * i) * (0.01 * i);
        for (const TPoint2D& corner : corners) {
            const TPoint2D ray = corner - origin;
            const auto hit = map.castRay(origin, ray * (1 / ray.norm()), maxRange, 0);
            ASSERT_TRUE(hit) << "from " << origin << " to " << corner;
        }
    }
}

TEST(CastRay, rayIntoAnInsideCornerEndsThere) {
    const LineMap map({wall({0, 4}, {3, 4}), wall({3, 4}, {3, 0})});
    for (const double y : {-3.0, 0.0, 1.0, 3.9}) {
        const TPoint2D origin(1, y), ray = TPoint2D(3, 4) - origin;
        const auto hit = map.castRay(origin, ray * (1 / ray.norm()), maxRange, 0);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->range, ray.norm(), 1e-14);  // a few roundings of 7 m
    }
}

TEST(CastRay, grazingHitLiesWithinItsWall) {
    // At an incidence of 1e-9 the crossing is ill-conditioned along the wall, never beyond its
    // ends.
    const LineMap map({wall({10, -1e-8}, {30, 1.2e-8})});
    const auto hit = map.castRay({0, 0}, {1, 0}, maxRange, 0);
    ASSERT_TRUE(hit);
    EXPECT_GE(hit->range, 10);
    EXPECT_LE(hit->range, 30);
    EXPECT_NEAR(hit->incidence.angle(), 2.2e-8 / 20, 1e-15);
}

TEST(CastRay, tiesTakeTheFirstWall) {
    const Wall copy = wall({5, -1}, {5, 1});
    std::vector<Wall> walls(50, copy);
    walls.insert(walls.begin(), wall({9, -1}, {9, 1}));
    const LineMap map(std::move(walls));
    EXPECT_EQ(map.castRay({0, 0}, {1, 0}, maxRange, 0)->wall, 1u);
    EXPECT_EQ(map.nearestWall({4, 0}, 5, 0)->wall, 1u);
}

TEST(CastRay, hitsAtEveryPowerOfTwo) {
    // The ray is looked up in pieces that end at 4, 8, 16 ... m; a wall may stand just there.
    for (double range = 1; range <= 64; range *= 2) {
        for (const double offset : {-1e-12, 0.0, 1e-12}) {
            for (int i = 0; i < 48; ++i) {
                const TPoint2D u = towards(pi * i / 24), origin(0.1 * i, -3);
                const TPoint2D at = origin + u * (range + offset), side(-u.y, u.x);
                const LineMap map({wall(at - side, at + side), wall(at + side * 2, at + u * 2)});
                const auto hit = map.castRay(origin, u, maxRange, 0);
                ASSERT_TRUE(hit) << "range " << range << " direction " << i;
                EXPECT_NEAR(hit->range, range + offset, 1e-13);  // ten roundings of 64 m
            }
        }
    }
}

TEST(NearestWall, measuresToEndsAndSides) {
    const LineMap map({wall({0, 0}, {4, 0}), wall({0, 3}, {4, 3}, 0.03, {0, 1})});
    EXPECT_DOUBLE_EQ(map.nearestWall({2, 1}, 5, 0.5)->distance, 1);
    EXPECT_DOUBLE_EQ(map.nearestWall({7, -4}, 5, 0.5)->distance, 5);
    EXPECT_EQ(map.nearestWall({2, 2}, 5, 0.5)->wall, 1u);
    EXPECT_EQ(map.nearestWall({2, 2}, 5, 1.5)->wall, 0u);
    EXPECT_FALSE(map.nearestWall({7, -4}, 4.9, 0.5));
    EXPECT_FALSE(map.nearestWall({4.8, -0.8}, 1, 0.5));  // within the square, not within reach
}

TEST(HasWallWithin, countsEveryHeightUpToTheDistance) {
    const LineMap map({wall({10, -1}, {10, 1}, 0.03, {5, 6})});
    EXPECT_TRUE(map.hasWallWithin({0, 0}, 10));
    EXPECT_TRUE(map.hasWallWithin({10, 0}, 0.5));
    EXPECT_FALSE(map.hasWallWithin({0, 0}, 9.99));
    EXPECT_FALSE(map.hasWallWithin({0, 8}, 11));  // in the square, but 12.2 m away
}

}  // namespace offmap::core
