// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>

#include <span>
#include <string>

namespace offmap::maps {

/// The text map of these walls, to a tenth of a millimetre: what parseTextMap() reads.
std::string textMapOf(std::span<const core::Wall> walls);

}  // namespace offmap::maps
