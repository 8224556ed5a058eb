// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/SampleWorlds.h>

#include <initializer_list>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TSegment2D;

constexpr double doorHeight = 2.0;  // [m]
constexpr double doorWidth = 0.9;   // [m]

/// Panels from point to point.
void addWalls(World& world, std::initializer_list<TPoint2D> points, double height, bool mapped) {
    for (const auto* point = points.begin(); point + 1 < points.end(); ++point) {
        const Panel panel{{*point, *(point + 1)}, {0, height}};
        mapped ? world.addMappedPanel(panel) : world.addPanel(panel);
    }
}

struct Doorway {
    TPoint2D begin, end;  ///< [m] its posts
};

/// The leaf of a door hung at a post, open at a right angle.
/// \param side -1 or 1: towards smaller or larger y
Panel openLeaf(const TPoint2D& post, int side) {
    return {{post, {post.x, post.y + side * doorWidth}}, {0, doorHeight}};
}

/// A wall along x that the map shows without its doorways. Above a doorway the wall goes on.
/// \param begins [m] x where the doorways begin, in ascending order
std::vector<Doorway> addWallWithDoorways(World& world, const TSegment2D& line, double height,
                                         std::initializer_list<double> begins) {
    const uint32_t wall = world.addToMap({.line = line});
    const double y = line.point1.y;
    std::vector<Doorway> doorways;
    double x = line.point1.x;
    for (const double begin : begins) {
        const Doorway door{{begin, y}, {begin + doorWidth, y}};
        world.addPanel({{{x, y}, door.begin}, {0, height}}, wall);
        world.addPanel({{door.begin, door.end}, {doorHeight, height}}, wall);
        doorways.push_back(door);
        x = door.end.x;
    }
    world.addPanel({{{x, y}, line.point2}, {0, height}}, wall);
    return doorways;
}

}  // namespace

Cylinder personAt(const TPoint2D& place) { return {place, 0.25, {0, 1.75}}; }

World officeRoom() {
    constexpr double height = 2.8;
    World world;
    world.addFloor();
    world.addCeiling(height);
    addWalls(world, {{0, 5}, {0, 0}, {8, 0}, {8, 5}}, height, true);

    const Doorway door = addWallWithDoorways(world, {{0, 5}, {8, 5}}, height, {5.0}).front();
    world.addObject(openLeaf(door.end, -1));
    addWalls(world, {{4, 5}, {4, 7}, {8.5, 7}, {8.5, 5}, {8, 5}}, height, false);

    world.addObject(personAt({4.5, 2.0}));
    world.addObject(Box{{3.5, 0.7, 0}, 0.6, 0.4, {0, 0.5}});
    return world;
}

World corridor() {
    constexpr double height = 2.5;
    World world;
    world.addFloor();
    world.addCeiling(height);
    addWalls(world, {{0, -1}, {0, 1}, {20, 1}, {20, -1}}, height, true);

    const auto doors = addWallWithDoorways(world, {{0, -1}, {20, -1}}, height, {6.0, 13.0});
    world.addObject(openLeaf(doors[0].begin, -1));
    world.addObject(openLeaf(doors[1].end, -1));
    addWalls(world, {{5, -1}, {5, -5}, {9, -5}, {9, -1}}, height, false);
    addWalls(world, {{12, -1}, {12, -4}, {15, -4}, {15, -1}}, height, false);
    world.addObject(Box{{8.75, -2.5, 0}, 0.5, 2.0, {0, 1.9}});  // cabinets
    world.addObject(Panel{{{18, -doorWidth / 2}, {18, doorWidth / 2}}, {0, doorHeight}});

    world.addObject(personAt({8.0, 0.3}));
    world.addObject(Box{{7.0, -0.4, 0.4}, 0.5, 0.35, {0, 0.5}});  // carton
    world.addObject(Cylinder{{0.1, 0.6}, 0.08, {0.6, 1.2}});      // fire extinguisher
    return world;
}

World bareCorridor() {
    constexpr double height = 2.5;
    World world;
    world.addFloor();
    world.addCeiling(height);
    addWalls(world, {{-200, -1.2}, {200, -1.2}}, height, true);
    addWalls(world, {{200, 1.2}, {-200, 1.2}}, height, true);
    return world;
}

}  // namespace offmap::evaluation
