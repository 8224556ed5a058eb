// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace offmap::rawlog {

/// Number of single-character edits that turn one text into the other (Levenshtein).
size_t editDistance(std::string_view a, std::string_view b);

}  // namespace offmap::rawlog
