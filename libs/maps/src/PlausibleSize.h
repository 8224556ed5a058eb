// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Coordinates.h"

#include <optional>
#include <string>

namespace offmap::maps {

/// What smells of the size of a map, and the option that mends it; none if nothing does.
/// \param extent [m] \param isProjected its coordinates were degrees
std::optional<std::string> sizeWarning(const Extent& extent, bool isProjected);

/// What is to know of a map that lies far from its origin; none if it does not. \param extent [m]
std::optional<std::string> farNote(const Extent& extent);

}  // namespace offmap::maps
