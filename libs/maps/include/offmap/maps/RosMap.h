// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <mrpt/poses/CPose2D.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// How the brightness of a pixel tells what a cell is.
enum class RosMapMode : uint8_t {
    Trinary,  ///< by the thresholds
    Scale,    ///< the same: what lies between the thresholds is as unknown here
    Raw,      ///< a byte is the chance of being occupied in percent, above 100 unknown
};

/// What the map.yaml of a ROS map says.
struct RosMapDescription {
    std::filesystem::path image;  ///< as it stands there
    double resolution = 0;        ///< [m] of a pixel
    mrpt::poses::CPose2D origin;  ///< of the picture's lower left corner
    bool negate = false;          ///< white is occupied
    double occupied = 0.65;       ///< occupied above this chance
    double free = 0.25;           ///< free below it
    RosMapMode mode = RosMapMode::Trinary;
    std::vector<std::string> warnings;
};

/// \param name stands for the file \throw std::runtime_error naming it, the line and the fix
RosMapDescription parseRosMap(std::string_view text, const std::string& name);

/// A map.yaml and its picture.
Drawing readRosMap(const std::filesystem::path& file, const MapOptions& options);

}  // namespace offmap::maps
