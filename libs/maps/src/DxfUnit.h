// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <string_view>

namespace offmap::maps {

/// What a drawing says of its unit.
struct DrawnUnit {
    std::string_view name;  ///< "inches"
    double metres;          ///< [m] of one
};

/// By the header variable $INSUNITS. None if it is missing, 0 (unitless) or of no known unit.
std::optional<DrawnUnit> dxfUnit(std::istream& dxf);

/// \throw std::runtime_error telling the fix if it is a binary DXF, which GDAL does not read
void requireTextDxf(std::istream& dxf);

}  // namespace offmap::maps
