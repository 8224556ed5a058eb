// SPDX-License-Identifier: BSD-3-Clause
#include "FloorPlan.h"

#include <offmap/evaluation/StandOff.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TSegment2D;

constexpr double doorWidth = 0.9, doorHeight = 2.0;  // [m]
/// Places are drawn until one is free. So many in vain: there is none.
constexpr int tries = 500;

TPoint2D middleOf(const Cylinder& cylinder) { return cylinder.centre; }
TPoint2D middleOf(const Box& box) { return {box.centre.x, box.centre.y}; }

Box boxAt(const TPoint2D& place, double phi, double length, double width, UniformNumbers& random) {
    return {{place.x, place.y, phi}, length, width, {0, random.between(0.4, 1.8)}};
}

Cylinder personAt(const TPoint2D& place, double radius, UniformNumbers& random) {
    return {place, radius, {0, random.between(1.5, 1.9)}};
}

double drawRadius(UniformNumbers& random) { return random.between(0.2, 0.3); }
double drawSide(UniformNumbers& random) { return random.between(0.3, 0.8); }

}  // namespace

FloorPlan::FloorPlan(const std::vector<TPoint2D>& corners, double height,
                     const std::vector<Doorway>& doorways) {
    for (const TPoint2D& corner : corners) corners_.push_back(corner);
    world_.addFloor();
    world_.addCeiling(height);
    for (size_t i = 0; i < corners_.size(); ++i) {
        const auto door = std::find_if(doorways.begin(), doorways.end(),
                                       [i](const Doorway& d) { return d.wall == i; });
        door == doorways.end() ? addWall(i, height) : addWallWithDoorway(*door, height);
    }
}

TSegment2D FloorPlan::wall(size_t i) const {
    return {corners_[i], corners_[(i + 1) % corners_.size()]};
}

TPoint2D FloorPlan::at(size_t wall, double along, double inwards) const {
    const TSegment2D line = this->wall(wall);
    const TPoint2D direction = (line.point2 - line.point1) * (1 / line.length());
    const TPoint2D normal(-direction.y, direction.x);
    return line.point1 + direction * along + normal * inwards;
}

void FloorPlan::addWall(size_t i, double height) { world_.addMappedPanel({wall(i), {0, height}}); }

void FloorPlan::addWallWithDoorway(const Doorway& door, double height) {
    const TPoint2D begin = at(door.wall, door.begin, 0);
    const TPoint2D end = at(door.wall, door.begin + doorWidth, 0);
    const uint32_t inMap = world_.addToMap({.line = wall(door.wall)});
    world_.addPanel({{wall(door.wall).point1, begin}, {0, height}}, inMap);
    world_.addPanel({{begin, end}, {doorHeight, height}}, inMap);
    world_.addPanel({{end, wall(door.wall).point2}, {0, height}}, inMap);
    addRoomBehind(door, height);
    keptFree_.push_back({(begin + end) * 0.5, 1.2});
}

void FloorPlan::addRoomBehind(const Doorway& door, double height) {
    constexpr double aside = 1.0, depth = 3.0;  // [m]
    const double left = door.begin - aside, right = door.begin + doorWidth + aside;
    const TPoint2D corners[] = {at(door.wall, left, 0), at(door.wall, left, -depth),
                                at(door.wall, right, -depth), at(door.wall, right, 0)};
    for (int i = 0; i < 3; ++i) world_.addPanel({{corners[i], corners[i + 1]}, {0, height}});
    const TSegment2D leaf(at(door.wall, door.begin, 0), at(door.wall, door.begin, -doorWidth));
    world_.addPanel({leaf, {0, doorHeight}});
}

TPoint2D FloorPlan::anywhere(UniformNumbers& random) const {
    TPoint2D low, high;
    corners_.getBoundingBox(low, high);
    return {random.between(low.x, high.x), random.between(low.y, high.y)};
}

core::SensorPose FloorPlan::placeSensor(UniformNumbers& random) {
    constexpr double clearance = 0.6, toObjects = 1.0;  // [m]
    TPoint2D place;
    const auto isNearAWall = [&] {
        for (size_t i = 0; i < corners_.size(); ++i) {
            if (wall(i).distance(place) < clearance) return true;
        }
        return false;
    };
    do {
        place = anywhere(random);
    } while (!corners_.contains(place) || isNearAWall());
    keptFree_.push_back({place, toObjects});
    const double z = random.between(0.5, 1.2);
    const double yaw = random.between(-std::numbers::pi, std::numbers::pi);
    return {.sensorInMap = {place.x, place.y, z, yaw, 0, 0}};
}

FloorPlan::Object FloorPlan::objectBefore(size_t wall, double along, double standOff,
                                          UniformNumbers& random) const {
    const double kind = random.between(0, 1);
    if (kind < 0.5) {
        const double length = drawSide(random), width = drawSide(random);
        const TPoint2D line = this->wall(wall).point2 - this->wall(wall).point1;
        const TPoint2D place = at(wall, along, standOff + width / 2);
        return boxAt(place, std::atan2(line.y, line.x), length, width, random);
    }
    const double radius = drawRadius(random);
    const TPoint2D place = at(wall, along, standOff + radius);
    Cylinder person = personAt(place, radius, random);
    if (kind < 0.75) return person;
    // leaning back: the head where an upright person would stand, the feet away from the wall
    const double slope = std::tan(mrpt::DEG2RAD(random.between(4, 10)));
    person.lean = (at(wall, 0, 0) - at(wall, 0, 1)) * slope;
    person.centre = place - person.lean * person.height.width();
    return person;
}

double FloorPlan::gapToWalls(const Object& object, std::optional<size_t> except) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < corners_.size(); ++i) {
        if (i == except) continue;
        nearest = std::min(
            nearest, std::visit([&](const auto& shape) { return gap(shape, wall(i)); }, object));
    }
    return nearest;
}

bool FloorPlan::isFree(const Object& object) const {
    const TPoint2D middle = std::visit([](const auto& o) { return middleOf(o); }, object);
    return corners_.contains(middle) &&
           std::all_of(keptFree_.begin(), keptFree_.end(), [&](const KeptFree& kept) {
               return (kept.centre - middle).norm() >= kept.radius;
           });
}

void FloorPlan::put(const Object& object) {
    constexpr double toEachOther = 1.2;  // [m] more than the diagonal of the largest box
    std::visit([this](const auto& shape) { world_.addObject(shape); }, object);
    keptFree_.push_back(
        {std::visit([](const auto& o) { return middleOf(o); }, object), toEachOther});
}

void FloorPlan::putBeforeWall(double standOff, UniformNumbers& random) {
    constexpr double clearer = 0.1;  // [m] than its wall stands every other
    double around = 0;
    for (size_t i = 0; i < corners_.size(); ++i) around += wall(i).length();
    for (int i = 0; i < tries; ++i) {
        double along = random.between(0, around);
        size_t chosen = 0;
        while (along > wall(chosen).length()) along -= wall(chosen++).length();
        const Object object = objectBefore(chosen, along, standOff, random);
        if (!isFree(object) || gapToWalls(object, chosen) < standOff + clearer) continue;
        return put(object);
    }
}

void FloorPlan::putInTheOpen(UniformNumbers& random) {
    constexpr double clearance = 0.55;  // [m]
    for (int i = 0; i < tries; ++i) {
        const TPoint2D place = anywhere(random);
        Object object = personAt(place, drawRadius(random), random);
        if (random.chance(0.5)) {
            const double phi = random.between(-std::numbers::pi, std::numbers::pi);
            const double length = drawSide(random), width = drawSide(random);
            object = boxAt(place, phi, length, width, random);
        }
        if (!isFree(object) || gapToWalls(object, std::nullopt) < clearance) continue;
        return put(object);
    }
}

}  // namespace offmap::evaluation
