// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Shapes.h>
#include <offmap/evaluation/UniformNumbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace offmap::evaluation {

namespace {

/// A ray from within 5 m of the origin, in any direction.
Ray anyRay(UniformNumbers& random) {
    const double azimuth = random.between(-std::numbers::pi, std::numbers::pi);
    const double z = random.between(-1, 1), level = std::sqrt(1 - z * z);
    return {{random.between(-5, 5), random.between(-5, 5), random.between(-1, 3)},
            {level * std::cos(azimuth), level * std::sin(azimuth), z}};
}

/// That no ray which meets the shape is taken for one that passes it, and that many are not.
template <class Shape>
void expectBoundsHold(const Shape& shape) {
    UniformNumbers random(1);
    int met = 0, passed = 0;
    for (int i = 0; i < 50000; ++i) {
        const Ray ray = anyRay(random);
        const bool mayMeet = boundsOf(shape).mayMeet(ray);
        if (!mayMeet) ++passed;
        if (!meet(ray, shape)) continue;
        ++met;
        EXPECT_TRUE(mayMeet) << i;
    }
    EXPECT_GT(met, 100);
    EXPECT_GT(passed, 10000);
}

}  // namespace

TEST(BoundingCircle, holdsItsShape) {
    expectBoundsHold(Panel{{{-1, 1}, {1, 2}}, {0, 2}});
    expectBoundsHold(Mesh{{{{-1, 1}, {1, 2}}, {0, 2}}, 0.2, 0.05});
    expectBoundsHold(Cylinder{{1, -1}, 0.4, {0, 2}, {0.2, -0.4}});
    expectBoundsHold(Box{{-1, 2, 0.4}, 1.5, 0.5, {0, 1}});
}

TEST(BoundingCircle, planeIsNeverPassed) {
    UniformNumbers random(2);
    for (int i = 0; i < 1000; ++i) EXPECT_TRUE(boundsOf(Plane{1}).mayMeet(anyRay(random)));
}

TEST(BoundingCircle, uprightRaysAreJudgedByTheirPlace) {
    const Box box{{2, 0, 0}, 1, 1, {0, 1}};
    EXPECT_TRUE(boundsOf(box).mayMeet({{2.4, 0.4, 5}, {0, 0, -1}}));
    EXPECT_TRUE(boundsOf(Plane{0}).mayMeet({{0, 0, 5}, {0, 0, -1}}));
}

}  // namespace offmap::evaluation
