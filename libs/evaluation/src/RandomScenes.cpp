// SPDX-License-Identifier: BSD-3-Clause
#include "FloorPlan.h"

#include <offmap/evaluation/RandomScenes.h>

#include <mrpt/poses/CPose2D.h>

#include <numbers>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;

void requireUsable(const SceneOptions& options) {
    if (options.standOffs.empty()) throw std::invalid_argument("a scene without any stand-off");
    for (const double standOff : options.standOffs) {
        if (!(standOff > 0 && standOff <= 0.5)) {
            throw std::invalid_argument("the stand-off of an object must be in (0, 0.5] m");
        }
    }
}

/// Turns and moves a plan to somewhere in the map.
std::vector<TPoint2D> anywhereInMap(const std::vector<TPoint2D>& corners, UniformNumbers& random) {
    const double phi = random.between(-std::numbers::pi, std::numbers::pi);
    const double x = random.between(-20, 20), y = random.between(-20, 20);
    const mrpt::poses::CPose2D planInMap(x, y, phi);
    std::vector<TPoint2D> moved;
    for (const TPoint2D& corner : corners) {
        moved.emplace_back(planInMap.composePoint(corner));
    }
    return moved;
}

/// Walls are bright, objects anything.
void paint(World& world, UniformNumbers& random) {
    for (uint32_t id = 0; id < world.surfaces().size(); ++id) {
        const bool isObject = world.surfaces()[id].kind == SurfaceKind::Object;
        world.setReflectivity(id, random.between(isObject ? 0.1 : 0.5, 0.9));
    }
}

Scene furnished(const std::vector<TPoint2D>& corners, const std::vector<Doorway>& doorways,
                const SceneOptions& options, UniformNumbers& random) {
    const double height = random.between(2.4, 3.2);
    FloorPlan plan(anywhereInMap(corners, random), height, doorways);
    const core::SensorPose sensor = plan.placeSensor(random);
    const size_t beforeWalls = 2 + random.below(3), open = 1 + random.below(2);
    for (size_t i = 0; i < beforeWalls; ++i) {
        plan.putBeforeWall(options.standOffs[random.below(options.standOffs.size())], random);
    }
    for (size_t i = 0; i < open; ++i) plan.putInTheOpen(random);
    Scene scene{plan.world(), sensor};
    paint(scene.world, random);
    return scene;
}

/// \param length [m] of the wall
Doorway doorwayIn(size_t wall, double length, UniformNumbers& random) {
    return {wall, random.between(1, length - 2)};
}

}  // namespace

Scene randomRoom(uint64_t seed, const SceneOptions& options) {
    requireUsable(options);
    UniformNumbers random(seed);
    const double x = random.between(5, 12), y = random.between(4, 9);
    std::vector<Doorway> doorways;
    if (random.chance(0.5)) {
        const size_t wall = random.below(4);
        doorways.push_back(doorwayIn(wall, wall % 2 == 0 ? x : y, random));
    }
    return furnished({{0, 0}, {x, 0}, {x, y}, {0, y}}, doorways, options, random);
}

Scene randomCorridor(uint64_t seed, const SceneOptions& options) {
    requireUsable(options);
    UniformNumbers random(seed);
    const double x = random.between(15, 25), y = random.between(1.8, 2.6);
    std::vector<Doorway> doorways;
    for (const size_t side : {0, 2}) {
        if (random.chance(0.7)) doorways.push_back(doorwayIn(side, x, random));
    }
    return furnished({{0, 0}, {x, 0}, {x, y}, {0, y}}, doorways, options, random);
}

Scene randomCorner(uint64_t seed, const SceneOptions& options) {
    requireUsable(options);
    UniformNumbers random(seed);
    const double x = random.between(5, 12), y = random.between(4, 9);
    const double across = random.between(0.3, 0.6) * x, along = random.between(0.3, 0.6) * y;
    return furnished({{0, 0}, {x, 0}, {x, along}, {across, along}, {across, y}, {0, y}}, {},
                     options, random);
}

Scene randomScene(uint64_t seed, const SceneOptions& options) {
    switch (seed % 3) {
        case 0:
            return randomRoom(seed, options);
        case 1:
            return randomCorridor(seed, options);
        default:
            return randomCorner(seed, options);
    }
}

}  // namespace offmap::evaluation
