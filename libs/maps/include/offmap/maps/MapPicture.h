// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// The extensions of pictures, lower case.
const std::vector<std::string_view>& pictureExtensions();

/// The picture of a plan: dark pixels are walls, light ones free, transparent ones unknown. Its
/// lower left corner is the origin.
/// \throw std::runtime_error naming the file and the fix, also without MapOptions::resolution
Drawing readMapPicture(const std::filesystem::path& file, const MapOptions& options);

}  // namespace offmap::maps
