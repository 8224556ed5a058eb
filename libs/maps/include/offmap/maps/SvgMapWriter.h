// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <span>
#include <string>

namespace offmap::maps {

/// The SVG drawing of walls in metres, at real size, that readSvgMap() reads back without being
/// told anything: layers are Inkscape's, arcs are arcs, coordinates are to a hundredth of a
/// millimetre. Sigma, height and the place of the map's origin stand in data- attributes, which
/// other programs leave alone. \param layerOfEach the layer's name of each wall \throw
/// std::invalid_argument if the names are not as many as the walls
std::string svgMapOf(std::span<const core::Wall> walls, std::span<const std::string> layerOfEach);

}  // namespace offmap::maps
