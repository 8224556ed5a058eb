// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ReductionTotals.h>

#include <string>

namespace offmap::app {

/// Lines of a summary: how many scans go together with map and poses, and which do not. Empty if
/// there is nothing to tell.
std::string healthText(const rawlog::ReductionTotals& totals);

}  // namespace offmap::app
