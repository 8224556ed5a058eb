// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace offmap::rawlog {

/// \throw std::invalid_argument if the level is not 0 (stored) to 9
void checkGzipLevel(int level);

/// The content as one gzip member, in the same bytes whenever this machine writes it. Members one
/// after the other are a gzip file. May be called in several threads at once.
/// \param level see checkGzipLevel(), which throws for others
std::vector<std::byte> gzipMember(std::span<const std::byte> content, int level);

}  // namespace offmap::rawlog
