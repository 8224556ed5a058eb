// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnLines.h"
#include "DxfUnit.h"
#include "VectorFormat.h"

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <optional>

namespace offmap::maps {

/// Makes the coordinates of the lines metres in a plane: by their unit, or by projecting those on
/// the earth. Says in the drawing's notes what was assumed, and in its warnings what smells.
/// \param unit that the file states \return whether it was projected
/// \throw std::runtime_error with the fix if the coordinates are of a kind that has no plane
bool placeInPlane(DrawnLines& lines, VectorKind kind, const std::optional<DrawnUnit>& unit,
                  const MapOptions& options, Drawing& drawing);

}  // namespace offmap::maps
