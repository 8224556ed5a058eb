// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// Extensions of the drawings and geographic data that readVectorDrawing() reads, lower case.
std::vector<std::string_view> vectorExtensions();

/// Reads the lines of a drawing (DXF) or of geographic data (GeoJSON, Shapefile, GeoPackage,
/// GML, KML, FlatGeobuf, OpenStreetMap) by GDAL. Arcs are arcs, other curves arcs within 2 mm.
/// \throw std::runtime_error naming the file, what is wrong with it and the fix
Drawing readVectorDrawing(const std::filesystem::path& file, const MapOptions& options);

}  // namespace offmap::maps
