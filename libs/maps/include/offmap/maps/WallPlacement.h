// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <mrpt/poses/CPose2D.h>

#include <vector>

namespace offmap::maps {

/// The walls of a map whose origin stands at mapOrigin in the frame wanted. Heights stay.
/// \param scale > 0, of the map's lengths, before it is placed; sigma and heights stay
std::vector<core::Wall> placed(std::vector<core::Wall> walls, const mrpt::poses::CPose2D& mapOrigin,
                               double scale = 1);

}  // namespace offmap::maps
