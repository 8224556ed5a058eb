// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/OccupancyGrid.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace offmap::maps {

/// A picture whose pixels are cells.
struct PictureGrid {
    OccupancyGrid grid;
    std::vector<std::string> warnings;
};

/// What a cell of some brightness is: 0 black ... 1 white, the mean of the colours.
using CellOfBrightness = std::function<Cell(double brightness)>;

/// Reads a PNG, PGM or PPM, BMP, JPEG or TIFF; its lowest row of pixels is the grid's first.
/// Transparent pixels are unknown. \param resolution [m] of a pixel
/// \throw std::runtime_error naming the file and what is wrong with it
PictureGrid readPicture(const std::filesystem::path& file, double resolution,
                        const CellOfBrightness& cellOf);

}  // namespace offmap::maps
