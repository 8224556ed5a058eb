// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Studies.h"

#include <filesystem>

namespace offmap::accuracy {

/// Writes what figures.gp draws, tab-separated, in percent: per scanner removal-I.tsv (noise level;
/// of each method mapped and unmapped points removed) and stand_off-I.tsv (distance [cm]; points
/// kept of each method at the middle level, then over all levels).
/// \throw std::runtime_error if a file cannot be written
void writeCurves(const Studies& studies, const std::filesystem::path& folder);

}  // namespace offmap::accuracy
