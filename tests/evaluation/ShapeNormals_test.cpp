// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace offmap::evaluation {

namespace {

using mrpt::math::TVector3D;

/// That two normals are the same, to either side.
void expectSameNormal(const TVector3D& a, const TVector3D& b) {
    EXPECT_NEAR(a.norm(), 1, 1e-12);
    EXPECT_NEAR(std::abs(a.x * b.x + a.y * b.y + a.z * b.z), 1, 1e-12) << a << b;
}

constexpr double s = std::numbers::sqrt2 / 2;

}  // namespace

TEST(NormalAt, ofPanelsAndPlanesIsTheSameEverywhere) {
    expectSameNormal(normalAt(Panel{{{1, 1}, {3, 3}}, {0, 2}}, {2, 2, 1}), {s, -s, 0});
    expectSameNormal(normalAt(Plane{2}, {5, 6, 2}), {0, 0, 1});
}

TEST(NormalAt, ofACylinderLeadsFromItsAxis) {
    const Cylinder upright{{1, 1}, 0.5, {0, 2}};
    expectSameNormal(normalAt(upright, {1.5, 1, 1}), {1, 0, 0});
    expectSameNormal(normalAt(upright, {1 - 0.5 * s, 1 - 0.5 * s, 0.2}), {s, s, 0});
    expectSameNormal(normalAt(upright, {1.2, 1.1, 2}), {0, 0, 1});
}

TEST(NormalAt, ofALeaningCylinderLeansWithIt) {
    // it leans by 45 degrees towards x: on that side the surface looks down, across it does not
    const Cylinder leaning{{0, 0}, 0.5, {0, 2}, {1, 0}};
    expectSameNormal(normalAt(leaning, {1.5, 0, 1}), {s, 0, -s});
    expectSameNormal(normalAt(leaning, {1, 0.5, 1}), {0, 1, 0});
}

TEST(NormalAt, ofABoxIsThatOfTheFace) {
    const Box box{{1, 2, 0}, 2, 1, {0, 0.5}};
    expectSameNormal(normalAt(box, {2, 2.3, 0.2}), {1, 0, 0});
    expectSameNormal(normalAt(box, {1.7, 1.5, 0.2}), {0, 1, 0});
    expectSameNormal(normalAt(box, {1.7, 2.1, 0.5}), {0, 0, 1});
    const Box turned{{0, 0, std::numbers::pi / 4}, 2, 1, {0, 0.5}};
    expectSameNormal(normalAt(turned, {s, s, 0.2}), {s, s, 0});
}

}  // namespace offmap::evaluation
