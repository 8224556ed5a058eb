// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CollinearIndex.h"

#include <vector>

namespace offmap::maps {

/// Makes one line of those that overlap or touch and lie on one line, and drops those that others
/// hold, until nothing changes. \param tolerance [m]
void mergeCollinear(std::vector<DrawnLine>& lines, double tolerance);

}  // namespace offmap::maps
