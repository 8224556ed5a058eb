// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/WallGeometry.h>

#include <span>

namespace offmap::maps {

/// The smallest rectangle along the axes that holds all walls. \pre there is one
core::WallBounds boundsOfAll(std::span<const core::Wall> walls);

}  // namespace offmap::maps
