// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>
#include <offmap/maps/MapFile.h>
#include <offmap/maps/SvgMap.h>

#include <cstdint>
#include <stdexcept>
#include <string_view>

/// Whatever the drawing: a message, or walls that make a map.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    offmap::maps::MapOptions options;
    options.minLength = 0.05;
    offmap::maps::MapOfFile map;
    try {
        map =
            offmap::maps::mapOf(offmap::maps::parseSvgMap(text, "fuzz", options), options, "fuzz");
    } catch (const std::runtime_error&) {
        return 0;
    }
    const offmap::core::LineMap lines(std::move(map.walls));
    static_cast<void>(lines.castRay({0, 0}, {1, 0}, 100, 1));
    return 0;
}
