// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnLines.h"
#include "VectorFormat.h"

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

namespace offmap::maps {

/// Makes the coordinates of the lines metres in a plane: by their unit, or by projecting those on
/// the earth. Says in the drawing's notes what was assumed, and in its warnings what smells.
/// \return whether they were degrees and are projected
/// \throw std::runtime_error with the fix if the coordinates are of a kind that has no plane
bool placeInPlane(DrawnLines& lines, VectorKind kind, const MapOptions& options, Drawing& drawing);

}  // namespace offmap::maps
