// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/Drawing.h>

#include <algorithm>

namespace offmap::maps {

uint32_t Drawing::layer(std::string_view name) {
    const auto found = std::ranges::find(layers, name);
    const auto index = static_cast<uint32_t>(found - layers.begin());
    if (found == layers.end()) layers.emplace_back(name);
    return index;
}

}  // namespace offmap::maps
