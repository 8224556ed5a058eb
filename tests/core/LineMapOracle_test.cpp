// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>

#include <gtest/gtest.h>
#include <mrpt/math/TObject2D.h>
#include <mrpt/math/geometry.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr double maxRange = 100;

/// Brute force over all walls, with MRPT's intersection of segments.
double rangeByBruteForce(const std::vector<Wall>& walls, const TPoint2D& origin,
                         const TPoint2D& direction, double z) {
    const mrpt::math::TSegment2D ray(origin, origin + direction * maxRange);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls) {
        mrpt::math::TObject2D crossing;
        TPoint2D at;
        if (!wall.height.contains(z) || !mrpt::math::intersect(ray, wall.line, crossing)) continue;
        if (!crossing.getPoint(at)) continue;
        nearest = std::min(nearest, (at - origin).norm());
    }
    return nearest;
}

struct RandomMap {
    explicit RandomMap(unsigned seed, double longestWall) : random(seed) {
        std::uniform_real_distribution<double> length(0.1, longestWall), low(-1, 1);
        for (int i = 0; i < 120; ++i) {
            const TPoint2D from = place();
            const Interval height =
                i % 3 == 0 ? Interval::around(low(random), 0.5) : Interval::everything();
            walls.push_back({{from, from + direction() * length(random)}, 0.03, height});
        }
    }
    TPoint2D place() {
        std::uniform_real_distribution<double> coordinate(-40, 40);
        const double x = coordinate(random);
        return {x, coordinate(random)};
    }
    TPoint2D direction() {
        const double angle =
            std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(random);
        return {std::cos(angle), std::sin(angle)};
    }
    std::mt19937 random;
    std::vector<Wall> walls;
};

}  // namespace

TEST(CastRay, agreesWithBruteForceOverRandomMaps) {
    int hits = 0, misses = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        RandomMap world(seed, seed % 2 == 0 ? 3 : 80);
        const LineMap map(world.walls);
        for (int i = 0; i < 200; ++i) {
            const TPoint2D origin = world.place(), direction = world.direction();
            const double expected = rangeByBruteForce(world.walls, origin, direction, 0);
            const auto hit = map.castRay(origin, direction, maxRange, 0);
            ASSERT_EQ(hit.has_value(), std::isfinite(expected)) << "map " << seed << " ray " << i;
            hit ? ++hits : ++misses;
            // The smallest angle among these 6,000 rays is some 1e-3: 1e3 roundings of 100 m.
            if (!hit) continue;
            ASSERT_NEAR(hit->range, expected, 1e-10) << "map " << seed << " ray " << i;
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(misses, 100);
}

TEST(NearestWall, agreesWithBruteForceOverRandomMaps) {
    int found = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        RandomMap world(seed, seed % 2 == 0 ? 3 : 80);
        const LineMap map(world.walls);
        for (int i = 0; i < 200; ++i) {
            const TPoint2D point = world.place();
            std::optional<NearestWall> expected;
            for (uint32_t w = 0; w < world.walls.size(); ++w) {
                const double distance = world.walls[w].line.distance(point);
                if (!world.walls[w].height.contains(0) || distance > 2) continue;
                if (!expected || distance < expected->distance) expected = {distance, w};
            }
            const auto nearest = map.nearestWall(point, 2, 0);
            ASSERT_EQ(nearest.has_value(), expected.has_value());
            found += nearest.has_value();
            if (!nearest || !expected) continue;
            EXPECT_EQ(nearest->wall, expected->wall);
            constexpr double rounding = 1e-12;  // [m] some roundings of 100 m
            EXPECT_TRUE(map.hasWallWithin(point, expected->distance + rounding));
        }
    }
    EXPECT_GT(found, 1000);
}

TEST(CastRay, millionWallsAnswerLikeTheFewOnTheRay) {
    // A square grid of 1 m cells, 707 x 707, less the walls of a free lane along y = 353.5.
    std::vector<Wall> walls;
    walls.reserve(1'000'000);
    constexpr int cells = 707;
    for (int x = 0; x < cells; ++x) {
        for (int y = 0; y < cells; ++y) {
            walls.push_back({{{double(x), double(y)}, {x + 1.0, double(y)}}});
            if (y != 353) walls.push_back({{{double(x), double(y)}, {double(x), y + 1.0}}});
        }
    }
    walls.push_back({{{90, 353}, {90, 354}}});
    ASSERT_EQ(walls.size(), 2u * cells * cells - cells + 1);  // 998,992
    const uint32_t last = static_cast<uint32_t>(walls.size() - 1);
    const LineMap map(std::move(walls));
    const auto along = map.castRay({0.5, 353.5}, {1, 0}, maxRange, 0);
    ASSERT_TRUE(along);
    EXPECT_EQ(along->wall, last);
    EXPECT_EQ(along->range, 89.5);
    EXPECT_FALSE(map.castRay({200.5, 353.5}, {1, 0}, maxRange, 0));
    EXPECT_DOUBLE_EQ(map.castRay({600.5, 600.25}, {0, 1}, maxRange, 0)->range, 0.75);
    EXPECT_DOUBLE_EQ(map.nearestWall({600.5, 600.125}, 1, 0)->distance, 0.125);
}

}  // namespace offmap::core
