// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/World.h>

namespace offmap::evaluation {

/// A person who stands upright: a cylinder of 0.5 m across, 1.75 m high.
Cylinder personAt(const mrpt::math::TPoint2D& place);

/// A room of 8 x 5 x 2.8 m with a corner at the origin. Not on the map: a person in the middle, a
/// carton 0.5 m before the wall at y = 0, and a door in the wall at y = 5. The map shows the door
/// closed: its wall runs through. In truth the leaf stands open at a right angle into the room, and
/// behind the doorway lies a small room. A sensor at (2, 2.5) sees all of it.
World officeRoom();

/// A corridor like that of the paper's indoor experiment (section 4.1), 20 x 2 x 2.5 m along x from
/// the origin. The doors on the left are closed and flush with the wall. On the right two doors
/// stand open where the map's wall runs through, one into an office with cabinets. Not on the map
/// either: a person and a carton, a door across the front part, and a fire extinguisher at the
/// back. A sensor at (4, 0) looks into the office and has person and carton before it.
World corridor();

}  // namespace offmap::evaluation
