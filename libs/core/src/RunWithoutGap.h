// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/PlanePoints.h>

#include <cstdint>

namespace offmap::core {

/// Where the points that lead up to `end` with no step above maxGap [m] begin.
/// \pre 0 < end <= points.size()
uint32_t beginOfRunWithoutGap(const PlanePoints& points, uint32_t end, double maxGap);

}  // namespace offmap::core
