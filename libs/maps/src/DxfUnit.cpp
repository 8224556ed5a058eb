// SPDX-License-Identifier: BSD-3-Clause
#include "DxfUnit.h"

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

namespace offmap::maps {

namespace {

/// By the value of $INSUNITS; those beyond a building have no name here.
constexpr std::array<DrawnUnit, 25> units{{{},
                                           {"inches", 0.0254},
                                           {"feet", 0.3048},
                                           {"miles", 1609.344},
                                           {"millimetres", 0.001},
                                           {"centimetres", 0.01},
                                           {"metres", 1},
                                           {"kilometres", 1000},
                                           {"microinches", 2.54e-8},
                                           {"mils", 2.54e-5},
                                           {"yards", 0.9144},
                                           {},
                                           {"nanometres", 1e-9},
                                           {"micrometres", 1e-6},
                                           {"decimetres", 0.1},
                                           {"decametres", 10},
                                           {"hectometres", 100},
                                           {},
                                           {},
                                           {},
                                           {},
                                           {"US survey feet", 1200.0 / 3937},
                                           {"US survey inches", 100.0 / 3937},
                                           {"US survey yards", 3600.0 / 3937},
                                           {"US survey miles", 6336000.0 / 3937}}};

/// A line without the blanks around it; false at the end of the file. A line that no DXF has ends
/// it too.
bool readLine(std::istream& in, std::string& line) {
    constexpr size_t longest = 65536;
    line.clear();
    char c = 0;
    while (in.get(c) && c != '\n') {
        if (line.size() == longest) return false;
        line += c;
    }
    if (!in && line.empty()) return false;
    constexpr const char* blanks = " \t\r";
    line.erase(0, line.find_first_not_of(blanks));
    line.erase(line.find_last_not_of(blanks) + 1);
    return true;
}

/// A code and what it codes.
struct Pair {
    std::string code, value;
    bool read(std::istream& in) { return readLine(in, code) && readLine(in, value); }
};

}  // namespace

std::optional<DrawnUnit> dxfUnit(std::istream& dxf) {
    Pair pair;
    while (pair.read(dxf)) {
        if (pair.code == "0" && pair.value == "ENDSEC") break;  // the header comes first
        if (pair.code != "9" || pair.value != "$INSUNITS") continue;
        if (!pair.read(dxf) || pair.code != "70") break;
        size_t value = 0;
        std::from_chars(pair.value.data(), pair.value.data() + pair.value.size(), value);
        if (value >= units.size() || units.at(value).metres == 0) break;
        return units.at(value);
    }
    return std::nullopt;
}

void requireTextDxf(std::istream& dxf) {
    constexpr std::string_view sign = "AutoCAD Binary DXF";
    std::string begin(sign.size(), '\0');
    dxf.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (begin != sign) return;
    throw std::runtime_error("is a binary DXF, which is not read; save it as ASCII DXF");
}

}  // namespace offmap::maps
