// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::maps {

enum class VectorKind : uint8_t { Cad, Geographic, StreetMap };

/// A format of drawings or geographic data, and GDAL's driver that reads it: no other may.
struct VectorFormat {
    std::string_view name;                     ///< "DXF"
    std::vector<std::string_view> extensions;  ///< lower case
    const char* driver;                        ///< its name in GDAL
    void (*enroll)();                          ///< makes GDAL know the driver
    VectorKind kind;
    std::vector<const char*> options;  ///< of the driver
};

const std::vector<VectorFormat>& vectorFormats();

/// \throw std::invalid_argument for another extension
const VectorFormat& vectorFormatOf(const std::filesystem::path& file);

}  // namespace offmap::maps
