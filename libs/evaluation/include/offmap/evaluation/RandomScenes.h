// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/SensorPose.h>
#include <offmap/evaluation/World.h>

#include <cstdint>
#include <vector>

namespace offmap::evaluation {

/// A world and where a sensor stands in it, level, without any uncertainty.
struct Scene {
    World world;
    core::SensorPose sensor;
};

struct SceneOptions {
    /// [m] from which the gap of every object before a wall is drawn, see standOffOf().
    std::vector<double> standOffs = {0.05, 0.1, 0.2, 0.3, 0.5};
};

// Scenes that a seed determines. Floor, ceiling 2.4 to 3.2 m high, mapped walls around, turned
// any way in the map. 2 to 4 persons, upright or leaning back to the wall, and boxes stand before
// walls, and 1 or 2 in the open, further than 0.55 m from any wall. The sensor stands 0.5 to 1.2 m
// high, at least 0.6 m from every wall and 1 m from the middle of every object. Open doors are
// closed on the map; their leaves and the small rooms behind are unmapped walls. Objects have any
// reflectivity from 0.1 to 0.9, the rest from 0.5.
// Each throws std::invalid_argument if there is no stand-off, or one outside (0, 0.5] m.

/// 5 to 12 m x 4 to 9 m; every other one with an open door.
Scene randomRoom(uint64_t seed, const SceneOptions& options = {});

/// 15 to 25 m x 1.8 to 2.6 m, with a wall at either end; mostly an open door on either side.
Scene randomCorridor(uint64_t seed, const SceneOptions& options = {});

/// L-shaped: two legs of 5 to 12 and 4 to 9 m length, 30 to 60 % of that across.
Scene randomCorner(uint64_t seed, const SceneOptions& options = {});

/// Room, corridor and corner in turn.
Scene randomScene(uint64_t seed, const SceneOptions& options = {});

}  // namespace offmap::evaluation
