// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

constexpr double sqrt2 = std::numbers::sqrt2;
/// A handful of roundings at coordinates below 10 m.
constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();

Ray ray(const TPoint3D& origin, const TVector3D& towards) {
    return {origin, towards * (1 / towards.norm())};
}

const Ray ahead = ray({0, 0, 1}, {1, 0, 0});

/// Across the x axis at 3 m, 1 m to the left, 2 m to the right, 2.5 m high.
const Panel panel{{{3, 1}, {3, -2}}, {0, 2.5}};

}  // namespace

TEST(PanelShape, straightAheadIsMetAtItsDistance) { EXPECT_EQ(meet(ahead, panel), 3.0); }

TEST(PanelShape, obliqueBeamIsLonger) {
    EXPECT_NEAR(meet(ray({0, 0, 1}, {3, 0, 1.5}), panel).value(), 3 / std::cos(std::atan(0.5)),
                rounding);
    EXPECT_NEAR(meet(ray({0, -2, 1}, {1, 1, 0}), panel).value(), 3 * sqrt2, rounding);
}

TEST(PanelShape, endsBelongToIt) {
    EXPECT_TRUE(meet(ray({0, 0, 1}, {3, 1, 0}), panel));
    EXPECT_TRUE(meet(ray({0, 0, 1}, {3, -2, 0}), panel));
    EXPECT_TRUE(meet(ray({0, 0, 0}, {1, 0, 0}), panel));
}

TEST(PanelShape, beamBesideOrAboveMisses) {
    EXPECT_FALSE(meet(ray({0, 0, 1}, {3, 1.001, 0}), panel));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {3, -2.001, 0}), panel));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {3, 0, 1.501}), panel));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {3, 0, -1.001}), panel));
}

TEST(PanelShape, behindOrParallelIsNotMet) {
    EXPECT_FALSE(meet(ray({0, 0, 1}, {-1, 0, 0}), panel));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {0, 1, 0}), panel));
    EXPECT_FALSE(meet(ray({3, 3, 1}, {0, -1, 0}), panel));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {0, 0, 1}), panel));
}

TEST(MeshShape, isMetAtItsWiresAlone) {
    // openings of 0.2 m from (3, 1) towards smaller y, wires 0.03 m broad, from z = 0 on
    const Mesh mesh{panel, 0.2, 0.03};
    EXPECT_EQ(meet(ray({0, 0.99, 0.1}, {1, 0, 0}), mesh), 3.0);  // on the first post
    EXPECT_EQ(meet(ray({0, 0.79, 0.1}, {1, 0, 0}), mesh), 3.0);  // on the next
    EXPECT_FALSE(meet(ray({0, 0.9, 0.1}, {1, 0, 0}), mesh));     // between
    EXPECT_EQ(meet(ray({0, 0.9, 0.41}, {1, 0, 0}), mesh), 3.0);  // on a wire across
    EXPECT_FALSE(meet(ray({0, 1.01, 0.41}, {1, 0, 0}), mesh));   // beside the fence
}

TEST(PlaneShape, isMetFromBothSides) {
    EXPECT_NEAR(meet(ray({0, 0, 1}, {1, 0, -1}), Plane{0}).value(), sqrt2, rounding);
    EXPECT_NEAR(meet(ray({0, 0, -1}, {1, 0, 1}), Plane{0}).value(), sqrt2, rounding);
    EXPECT_FALSE(meet(ray({0, 0, 1}, {1, 0, 1}), Plane{0}));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {1, 0, 0}), Plane{0}));
}

TEST(CylinderShape, sideIsMetARadiusBeforeTheAxis) {
    const Cylinder cylinder{{5, 0}, 0.25, {0, 1.75}};
    EXPECT_NEAR(meet(ahead, cylinder).value(), 4.75, rounding);
    // 0.15 m off the axis: sqrt(0.25^2 - 0.15^2) = 0.2
    EXPECT_NEAR(meet(ray({0, 0.15, 1}, {1, 0, 0}), cylinder).value(), 4.8, rounding);
}

TEST(CylinderShape, beamPastItMisses) {
    const Cylinder cylinder{{5, 0}, 0.25, {0, 1.75}};
    EXPECT_FALSE(meet(ray({0, 0.2501, 1}, {1, 0, 0}), cylinder));
    EXPECT_FALSE(meet(ray({0, 0, 1.76}, {1, 0, 0}), cylinder));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {-1, 0, 0}), cylinder));
    EXPECT_FALSE(meet(ray({4, 0, 1}, {0, 0, 1}), cylinder));
}

TEST(CylinderShape, topIsMetFromAbove) {
    const Cylinder cylinder{{5, 0}, 0.25, {0, 1.75}};
    EXPECT_NEAR(meet(ray({4, 0, 2.75}, {1, 0, -1}), cylinder).value(), sqrt2, rounding);
    EXPECT_NEAR(meet(ray({5.1, 0.1, 3}, {0, 0, -1}), cylinder).value(), 1.25, rounding);
}

TEST(CylinderShape, isNotMetFromInside) {
    const Cylinder cylinder{{0, 0}, 0.25, {0, 1.75}};
    EXPECT_FALSE(meet(ahead, cylinder));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {0, 0, 1}), cylinder));
}

TEST(CylinderShape, leaningOneIsMetWhereItsSectionStands) {
    // 10 cm towards the ray per metre: at z = 1.5 the centre stands at x = 3 - 0.15
    const Cylinder leaning{{3, 0}, 0.25, {0, 2}, {-0.1, 0}};
    EXPECT_NEAR(meet(ray({0, 0, 1.5}, {1, 0, 0}), leaning).value(), 3 - 0.15 - 0.25, rounding);
    EXPECT_FALSE(meet(ray({0, 0.251, 1.5}, {1, 0, 0}), leaning));
    // from above onto its top, which ends at x = 3 - 0.2 + 0.25
    EXPECT_NEAR(meet(ray({3.04, 0, 5}, {0, 0, -1}), leaning).value(), 3, rounding);
    EXPECT_FALSE(meet(ray({3.06, 0, 5}, {1e-9, 0, -1}), Cylinder{{3, 0}, 0.05, {0, 2}, {-0.1, 0}}));
}

TEST(BoxShape, sidesAreMet) {
    EXPECT_NEAR(meet(ahead, Box{{4, 0, 0}, 2, 0.5, {0, 2}}).value(), 3, rounding);
    EXPECT_NEAR(meet(ahead, Box{{4, 0, std::numbers::pi / 2}, 2, 0.5, {0, 2}}).value(), 3.75,
                rounding);
    // a square turned by 45 degrees shows its corner
    EXPECT_NEAR(meet(ahead, Box{{4, 0, std::numbers::pi / 4}, 2, 2, {0, 2}}).value(), 4 - sqrt2,
                rounding);
}

TEST(BoxShape, beamPastItMisses) {
    const Box box{{4, 0, 0}, 2, 0.5, {0, 2}};
    EXPECT_FALSE(meet(ray({0, 0.2501, 1}, {1, 0, 0}), box));
    EXPECT_FALSE(meet(ray({0, 0, 2.001}, {1, 0, 0}), box));
    EXPECT_FALSE(meet(ray({0, 0, 1}, {-1, 0, 0}), box));
}

TEST(BoxShape, topIsMetFromAbove) {
    const Box box{{4, 0, 0.3}, 2, 2, {0, 0.5}};
    EXPECT_NEAR(meet(ray({3, 0, 1.5}, {1, 0, -1}), box).value(), sqrt2, rounding);
}

TEST(BoxShape, isNotMetFromInside) { EXPECT_FALSE(meet(ahead, Box{{0, 0, 0}, 2, 2, {0, 2}})); }

}  // namespace offmap::evaluation
