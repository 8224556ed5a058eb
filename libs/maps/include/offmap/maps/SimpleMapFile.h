// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <filesystem>

namespace offmap::maps {

/// An MRPT .simplemap or .simplemap.gz: its 2D laser scans are drawn into a grid, of 5 cm or of
/// MapOptions::resolution. MRPT reads it and trusts its numbers: damaged files are to be read in a
/// process of their own.
/// \throw std::runtime_error naming the file and what is wrong with it
Drawing readSimpleMap(const std::filesystem::path& file, const MapOptions& options);

}  // namespace offmap::maps
