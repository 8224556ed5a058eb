// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>
#include <offmap/maps/TextMap.h>

#include <cstdint>
#include <stdexcept>
#include <string_view>

/// Whatever the text: a message, or walls that make a map.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    std::vector<offmap::core::Wall> walls;
    try {
        walls = offmap::maps::parseTextMap(text, "fuzz", 0.03);
    } catch (const std::runtime_error&) {
        return 0;
    }
    const offmap::core::LineMap map(std::move(walls));
    static_cast<void>(map.castRay({0, 0}, {1, 0}, 100, 1));
    return 0;
}
