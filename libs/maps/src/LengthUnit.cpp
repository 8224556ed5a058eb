// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/LengthUnit.h>

#include <array>

namespace offmap::maps {

namespace {

struct NamedUnit {
    LengthUnit unit;
    std::string_view word;
    double metres;
};

constexpr std::array<NamedUnit, 5> units{{{LengthUnit::Metre, "m", 1},
                                          {LengthUnit::Centimetre, "cm", 0.01},
                                          {LengthUnit::Millimetre, "mm", 0.001},
                                          {LengthUnit::Inch, "in", 0.0254},
                                          {LengthUnit::Foot, "ft", 0.3048}}};

const NamedUnit& find(LengthUnit unit) { return units.at(static_cast<size_t>(unit)); }

}  // namespace

double inMetres(LengthUnit unit) { return find(unit).metres; }

std::string_view toString(LengthUnit unit) { return find(unit).word; }

std::optional<LengthUnit> lengthUnitOf(std::string_view word) {
    for (const NamedUnit& named : units) {
        if (named.word == word) return named.unit;
    }
    return std::nullopt;
}

}  // namespace offmap::maps
