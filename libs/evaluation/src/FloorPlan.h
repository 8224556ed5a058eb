// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/RandomScenes.h>
#include <offmap/evaluation/UniformNumbers.h>

#include <mrpt/math/TPolygon2D.h>

#include <variant>
#include <vector>

namespace offmap::evaluation {

struct Doorway {
    size_t wall;
    double begin;  ///< [m] along the wall
};

/// The closed ring of walls of a scene, and the objects that are put at random into it.
class FloorPlan {
 public:
    /// \param corners [m] counter-clockwise \param height [m] of the ceiling
    FloorPlan(const std::vector<mrpt::math::TPoint2D>& corners, double height,
              const std::vector<Doorway>& doorways);

    /// Somewhere inside, away from the walls. Call it before objects are put.
    core::SensorPose placeSensor(UniformNumbers& random);
    /// An object whose outline stands this far from the nearest wall. [m]
    void putBeforeWall(double standOff, UniformNumbers& random);
    void putInTheOpen(UniformNumbers& random);

    const World& world() const { return world_; }

 private:
    using Object = std::variant<Cylinder, Box>;

    mrpt::math::TSegment2D wall(size_t i) const;
    /// A place by its way along a wall and away from it, inwards. [m]
    mrpt::math::TPoint2D at(size_t wall, double along, double inwards) const;
    void addWall(size_t i, double height);
    void addWallWithDoorway(const Doorway& door, double height);
    void addRoomBehind(const Doorway& door, double height);

    mrpt::math::TPoint2D anywhere(UniformNumbers& random) const;
    Object objectBefore(size_t wall, double along, double standOff, UniformNumbers& random) const;
    /// Distance of an object from the nearest wall but one. [m]
    double gapToWalls(const Object& object, std::optional<size_t> except) const;
    bool isFree(const Object& object) const;
    void put(const Object& object);

    mrpt::math::TPolygon2D corners_;
    World world_;
    /// [m] around a place, where the middle of no object may stand
    struct KeptFree {
        mrpt::math::TPoint2D centre;
        double radius;
    };
    std::vector<KeptFree> keptFree_;
};

}  // namespace offmap::evaluation
