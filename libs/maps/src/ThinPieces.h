// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "GridFaces.h"
#include "StraightPieces.h"

#include <span>
#include <vector>

namespace offmap::maps {

/// A straight run of faces and the line that stands for it.
struct Piece {
    std::span<const Face> faces;
    size_t chainFaces = 0;  ///< of the chain that it is a part of
    PieceLine line;
    bool isThin = false;  ///< the line stands in the middle of the cells
    bool isKept = true;
};

/// Moves the line to the middle of the cells if the wall is about one cell thick: what was drawn
/// there is a line, and the surface stands on average half a cell behind the face.
void thin(const OccupancyGrid& grid, Piece& piece);

/// Of thin pieces that are the two sides of one wall one stays.
void keepOneSide(const OccupancyGrid& grid, std::vector<Piece>& pieces);

}  // namespace offmap::maps
