// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Studies.h"

#include <string>

namespace offmap::accuracy {

// Tables in Markdown. Percentages unless said otherwise.

std::string percentOf(std::optional<double> share);

/// One row per method: the figures over all noise levels.
std::string overallTable(const ScannerStudies& of);

/// One row per noise level, three figures per method.
std::string cellTable(const Study& cells);

/// One row per stand-off: points of objects kept, at the middle level and over all.
std::string standOffTable(const ScannerStudies& of);

/// One row per method: unmapped points removed, by the kind of their surface.
std::string surfaceTable(const Pools& pools);

/// One row per condition: mapped on segments and unmapped removed, kept whole, flagged; `aligned`
/// beside `paper`.
std::string conditionTable(const Study& study);

/// One row per noise level: errors of the pose before and after.
std::string poseTable(const Study& cells);

/// One row per method: points on vertical segments and removed ones, beside the paper's count.
std::string paperCorridorTable(const Pools& pools);

/// Along and across a corridor without ends.
std::string bareCorridorTable(const Pool& aligned);

/// The scans that a pool lost most mapped points of, then those that lost most unmapped ones.
std::string worstTable(const Pool& pool, size_t rows);

}  // namespace offmap::accuracy
