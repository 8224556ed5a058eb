// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/maps/Drawing.h>
#include <offmap/maps/MapOptions.h>

#include <filesystem>
#include <string_view>

namespace offmap::maps {

/// Reads what an SVG drawing shows as lines: its shapes and paths, gzip or plain. The lower left
/// corner of the viewBox is (0, 0), y goes up; user units are lengths by the drawing's width and
/// height, or by MapOptions::units. Layers are those of Inkscape, else the outermost groups with an
/// id. \throw std::runtime_error naming file, line, element and what is wrong
Drawing readSvgMap(const std::filesystem::path& file, const MapOptions& options);

/// The same for a drawing in memory, plain. \param name stands for the file in messages
Drawing parseSvgMap(std::string_view text, std::string_view name, const MapOptions& options);

}  // namespace offmap::maps
