// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace offmap::maps {

/// What one unit of a drawing is.
enum class LengthUnit : uint8_t { Metre, Centimetre, Millimetre, Inch, Foot };

/// [m] of one unit.
double inMetres(LengthUnit unit);

/// "m", "cm", "mm", "in", "ft", as on the command line.
std::string_view toString(LengthUnit unit);

/// None if it is none of those words.
std::optional<LengthUnit> lengthUnitOf(std::string_view word);

}  // namespace offmap::maps
