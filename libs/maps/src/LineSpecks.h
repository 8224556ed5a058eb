// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <span>
#include <vector>

namespace offmap::maps {

/// Of each wall, whether it is shorter than minLength and does not reach further together with
/// those that join its ends, end to end within a millimetre. \param minLength [m]
std::vector<bool> specksAmong(std::span<const core::Wall> walls, double minLength);

}  // namespace offmap::maps
