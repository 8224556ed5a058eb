// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace offmap::maps {

/// What a drawing says of its unit.
struct DrawnUnit {
    std::string_view name;  ///< "inches"
    double metres;          ///< [m] of one
};

/// What is to know of a DXF before GDAL reads it, which hands on neither the unit nor the class of
/// what blocks hold.
struct DxfContent {
    std::optional<DrawnUnit> unit;          ///< by $INSUNITS; none: unitless, or not of a building
    std::map<std::string, size_t> leftOut;  ///< by what is no wall, "hatches": how many
    std::vector<std::string> layers;        ///< of these
    std::map<std::string, size_t> unread;   ///< by entity type that GDAL does not know: how many
};

/// Looks through the bytes of a DXF and renames the entities that are no walls, so that GDAL passes
/// over them.
/// \throw std::runtime_error with the fix if it is a binary DXF, which GDAL does not read
DxfContent siftDxf(std::string& bytes);

}  // namespace offmap::maps
