// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <filesystem>
#include <span>
#include <string>

namespace offmap::maps {

/// Writes walls in metres as a drawing, DXF or GeoJSON by the extension .dxf, .geojson or .json.
/// Arcs become polylines that keep within half a millimetre; readMap() finds the arcs again.
/// GeoJSON keeps sigma and height, DXF has no place for them. A file of that name is replaced when
/// the new one is complete. \param layerOfEach the layer's name of each wall; as many as walls
/// \throw std::invalid_argument for another extension, or if the names are not as many as the walls
/// \throw std::runtime_error naming the file and what is wrong if it cannot be written
void writeDrawing(const std::filesystem::path& file, std::span<const core::Wall> walls,
                  std::span<const std::string> layerOfEach);

}  // namespace offmap::maps
