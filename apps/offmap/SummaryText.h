// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ReductionTotals.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace offmap::app {

/// The figures of one reduction or of several, a line each, for a person to read at a glance.
/// \param wallSeconds [s] that it took
std::string summaryOf(const rawlog::ReductionTotals& totals, double wallSeconds);

/// The same of one log among others, in a line. \param nameWidth [character] of the longest name
std::string summaryLineOf(const rawlog::ReductionTotals& totals, const std::string& name,
                          size_t nameWidth);

/// [byte] 0 if it is gone already
uint64_t sizeOf(const std::filesystem::path& file);

/// "212.4 MB"
std::string sizeText(uint64_t bytes);

}  // namespace offmap::app
