// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>
#include <offmap/maps/MapFile.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

/// In memory where there is such a folder; of this process alone.
fs::path fileOf(const char* extension) {
    static const fs::path memory = "/dev/shm";
    const fs::path folder = fs::exists(memory) ? memory : fs::temp_directory_path();
    return folder / ("offmap_drawing_fuzz." + std::to_string(getpid()) + extension);
}

}  // namespace

/// Whatever the bytes behind the first, which chooses the format: a message, or walls that make a
/// map.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    constexpr std::array extensions{".dxf", ".geojson", ".gml", ".kml", ".osm", ".fgb", ".pbf"};
    if (size < 2) return 0;
    const fs::path file = fileOf(extensions[bytes[0] % extensions.size()]);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes) + 1, static_cast<std::streamsize>(size - 1));
    std::vector<offmap::core::Wall> walls;
    try {
        walls = offmap::maps::readMap(file, {}).walls;
    } catch (const std::runtime_error&) {
    }
    fs::remove(file);
    const offmap::core::LineMap map(std::move(walls));
    static_cast<void>(map.castRay({0, 0}, {1, 0}, 100, 1));
    return 0;
}
