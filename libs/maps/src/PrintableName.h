// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace offmap::maps {

/// Text out of a file as it may be printed: UTF-8 without control bytes, other bytes become '?';
/// cut behind so many bytes.
std::string printableName(std::string_view text, size_t most = 120);

}  // namespace offmap::maps
