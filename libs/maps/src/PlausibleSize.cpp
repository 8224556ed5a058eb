// SPDX-License-Identifier: BSD-3-Clause
#include "PlausibleSize.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace offmap::maps {

namespace {

std::string length(double metres) {
    return metres < 10000 ? fmt::format("{:.3g} m", metres)
                          : fmt::format("{:.0f} km", metres / 1000);
}

}  // namespace

std::optional<std::string> sizeWarning(const Extent& extent, bool isProjected) {
    constexpr double smallest = 3, largest = 2000, largestOnEarth = 100'000;  // [m]
    if (extent.isEmpty()) return std::nullopt;
    const double size = std::max(extent.width(), extent.depth());
    const std::string is =
        fmt::format("the map is {} x {}", length(extent.width()), length(extent.depth()));
    if (isProjected) {
        if (size <= largestOnEarth) return std::nullopt;
        return is + ": are its coordinates metres, not degrees? --map-crs local takes them so";
    }
    if (size < smallest)
        return is + ": does the unit hold? --map-units m (cm, mm, in, ft) says better";
    if (size > largest) return is + ": are these millimetres? --map-units mm says so";
    return std::nullopt;
}

std::optional<std::string> farNote(const Extent& extent) {
    constexpr double far = 100'000;  // [m]
    if (extent.isEmpty()) return std::nullopt;
    const double distance = std::max({std::abs(extent.low.x), std::abs(extent.low.y),
                                      std::abs(extent.high.x), std::abs(extent.high.y)});
    if (distance < far) return std::nullopt;
    return fmt::format(
        "its places lie up to {} from its origin: the poses have to be in that frame, else "
        "--map-anchor (of a map of the earth) or --map-origin shifts it",
        length(distance));
}

}  // namespace offmap::maps
