// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <mrpt/math/TPoint2D.h>

#include <span>
#include <vector>

namespace offmap::maps {

/// The walls along a line through these places, each from where the one before ends. A run of short
/// pieces that an arc follows within 2 mm, as drawings give their curves, becomes arcs of at most a
/// quarter of a circle. Places less than a micrometre behind another are passed over: a line within
/// one gives no wall. \param places [m], finite \param like sigma and height of each wall
std::vector<core::Wall> wallsThrough(std::span<const mrpt::math::TPoint2D> places,
                                     const core::Wall& like);

}  // namespace offmap::maps
