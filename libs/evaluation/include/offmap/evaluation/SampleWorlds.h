// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/evaluation/World.h>

#include <cstddef>

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

/// A parking lot like that of the paper's outdoor experiment (section 4.2), 100 x 70 m around the
/// origin. The map shows the warehouses on three sides. Not on the map: parked cars and a lorry, a
/// wire fence on the right (smaller y), a bush in front, and two persons. No ceiling.
World parkingLot();

/// A corridor of 400 x 2.4 x 2.5 m along x, with its middle at the origin: whoever looks no further
/// than 100 m sees two bare walls, and nothing tells where along them.
World bareCorridor();

/// A hall of 16 x 6 x 4 m with its middle at (0, -3), whose wall on the left (y = 0) bends out to
/// y = 4, an arc of 10 m radius. Not on the map: a person, and a crate before the arc.
/// \param chords by how many the map shows the arc, each as long as the next; 0: as an arc
/// \throw std::invalid_argument unless 64 can be shared among them
World curvedHall(size_t chords = 8);

}  // namespace offmap::evaluation
