// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/RosMap.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

/// Whatever the text: a message, or a description that a picture can be read by.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    try {
        const auto map = offmap::maps::parseRosMap(text, "fuzz.yaml");
        if (!(map.resolution > 0) || !std::isfinite(map.origin.phi()) || map.image.empty()) {
            std::abort();
        }
    } catch (const std::runtime_error&) {
        return 0;
    }
    return 0;
}
