// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/rawlog/ReductionTotals.h>

#include <string>

namespace offmap::app {

/// "plan.lines: 214 walls, 612.4 m"
std::string describe(const core::LineMap& map, const std::string& name);

/// The figures of a reduction, a line each, for a person to read at a glance.
/// \param wallSeconds [s] that it took
std::string summaryOf(const rawlog::ReductionTotals& totals, double wallSeconds);

}  // namespace offmap::app
