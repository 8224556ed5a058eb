// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// Reads a text map: one wall a line, `x1 y1 x2 y2 [sigma [z_min z_max]]` in metres, map frame, or
/// `arc cx cy r start_deg end_deg [sigma [z_min z_max]]`, counter-clockwise from start to end; an
/// arc becomes several walls, each at most a quarter of the circle.
/// `#` starts a comment, blank lines are skipped; numbers have a decimal point whatever the locale.
/// \param defaultSigma [m] of walls that do not tell theirs
/// \throw std::runtime_error naming file, line, what stands there and what should: if the file
/// cannot be read, a line is not a wall, or there is no wall at all.
std::vector<core::Wall> readTextMap(const std::filesystem::path& file, double defaultSigma);

/// The same for text in memory. \param name stands for the file in messages
std::vector<core::Wall> parseTextMap(std::string_view text, std::string_view name,
                                     double defaultSigma);

}  // namespace offmap::maps
