// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SampleWorlds.h>
#include <offmap/evaluation/UniformNumbers.h>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

/// \param corners [m] of a building
void addBuilding(World& world, const std::vector<TPoint2D>& corners, double height) {
    for (size_t i = 0; i < corners.size(); ++i) {
        world.addMappedPanel({{corners[i], corners[(i + 1) % corners.size()]}, {0, height}});
    }
}

void addCar(World& world, const TPose2D& place) {
    world.addObject(Box{place, 4.4, 1.8, {0.25, 0.9}});
    world.addObject(Box{place, 2.2, 1.6, {0.9, 1.45}});
}

/// Posts and wires. \param begin, end [m] along x
void addFence(World& world, double begin, double end, double y) {
    constexpr double height = 1.8, postDistance = 2.5;  // [m]
    for (double x = begin; x <= end; x += postDistance) {
        world.addObject(Cylinder{{x, y}, 0.03, {0, height}});
    }
    world.addObject(Mesh{{{{begin, y}, {end, y}}, {0.05, height}}, 0.2, 0.03});
}

/// Twigs that lean any way.
void addBush(World& world, const TPoint2D& middle) {
    UniformNumbers random(1);
    for (int i = 0; i < 60; ++i) {
        const double x = middle.x + random.between(-0.8, 0.8);
        const double y = middle.y + random.between(-2.5, 2.5);
        const double radius = random.between(0.02, 0.08), begin = random.between(0, 0.8);
        Cylinder twig{{x, y}, radius, {begin, begin + random.between(0.4, 1.0)}};
        twig.lean = {random.between(-0.6, 0.6), random.between(-0.6, 0.6)};
        world.addObject(twig);
    }
}

}  // namespace

World parkingLot() {
    World world;
    world.addFloor();
    addBuilding(world, {{-40, 22}, {10, 22}, {10, 35}, {-40, 35}}, 8);
    addBuilding(world, {{18, 18}, {50, 18}, {50, 35}, {18, 35}}, 6);
    addBuilding(world, {{-50, -20}, {-32, -20}, {-32, 12}, {-50, 12}}, 7);
    addBuilding(world, {{-20, -35}, {45, -35}, {45, -24}, {-20, -24}}, 9);

    for (const double x : {-20.0, -17.2, -14.4, -8.8, -6.0, 2.4}) addCar(world, {x, 12, 1.5708});
    for (const double x : {-12.0, -3.0, 8.0}) addCar(world, {x, -7, 0.05});
    world.addObject(Box{{20, 8, 0.3}, 9, 2.5, {0.4, 3.6}});  // lorry
    addFence(world, -28, 32, -12);
    addBush(world, {12, 0.5});
    world.addObject(personAt({5, 3}));
    world.addObject(personAt({-4, -3.5}));
    return world;
}

}  // namespace offmap::evaluation
