// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/RosMapWriter.h>

#include <fmt/format.h>

namespace offmap::maps {

namespace {

/// As a YAML string in double quotes.
std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20) {
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
            out += c;
        }
    }
    return out + '"';
}

char brightnessOf(Cell cell) {
    constexpr int occupied = 0, unknown = 205, free = 254;
    return static_cast<char>(cell == Cell::Occupied ? occupied
                             : cell == Cell::Free   ? free
                                                    : unknown);
}

}  // namespace

std::string rosPictureOf(const OccupancyGrid& grid) {
    std::string bytes = fmt::format("P5\n{} {}\n255\n", grid.width, grid.height);
    bytes.reserve(bytes.size() + grid.cells.size());
    for (int row = grid.height - 1; row >= 0; --row) {
        for (int column = 0; column < grid.width; ++column) {
            bytes += brightnessOf(grid.at(column, row));
        }
    }
    return bytes;
}

// The thresholds of ROS's map_saver. Brightness 205 is a chance of (255 - 205) / 255 = 0.19608 of
// being occupied: just above free_thresh, so unknown.
std::string rosYamlOf(const OccupancyGrid& grid, std::string_view picture) {
    return fmt::format(
        "image: {}\n"
        "mode: trinary\n"
        "resolution: {:.9g}\n"
        "origin: [{:.6f}, {:.6f}, {:.9f}]\n"
        "negate: 0\n"
        "occupied_thresh: 0.65\n"
        "free_thresh: 0.196\n",
        quoted(picture), grid.resolution, grid.origin.x(), grid.origin.y(), grid.origin.phi());
}

}  // namespace offmap::maps
