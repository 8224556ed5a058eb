// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace offmap::maps {

/// What a file holds.
/// \throw std::runtime_error naming it if it cannot be read, or holds more bytes than that
std::string bytesOf(const std::filesystem::path& file, size_t most);

}  // namespace offmap::maps
