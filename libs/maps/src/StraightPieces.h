// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "GridFaces.h"
#include "PieceLine.h"

#include <span>
#include <vector>

namespace offmap::maps {

/// The line that a straight run of faces stands for: that of least squares, if every face is within
/// half a cell of it, else the one that is as near as can be to the face furthest from it.
PieceLine lineAlong(std::span<const Face> faces);

/// Cuts a chain where it bends, into pieces of which each lies within half a cell of some line. A
/// closed chain is turned first so that it begins at a bend.
/// \return where each piece begins, and the chain's length
std::vector<size_t> straightPieces(FaceChain& chain);

}  // namespace offmap::maps
