// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <span>
#include <string>

namespace offmap::maps {

/// A DXF drawing (AutoCAD 2004) of walls in metres, which it says in $INSUNITS. Arcs are polylines
/// that keep within half a millimetre; readMap() finds the arcs again. It has no place for sigma
/// and height. \param layerOfEach the layer's name of each wall; signs that DXF forbids become '_'
/// \throw std::invalid_argument if the names are not as many as the walls
std::string dxfOf(std::span<const core::Wall> walls, std::span<const std::string> layerOfEach);

/// GeoJSON of walls in metres, which it says in the member "crs"; programs that ignore that member
/// take them for degrees. Arcs as in dxfOf(). Each line has the properties Layer, sigma_m, and
/// where it is bounded z_min_m and z_max_m; readMap() reads them back. \throw std::invalid_argument
/// if the names are not as many as the walls
std::string geoJsonOf(std::span<const core::Wall> walls, std::span<const std::string> layerOfEach);

}  // namespace offmap::maps
