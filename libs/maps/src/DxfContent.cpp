// SPDX-License-Identifier: BSD-3-Clause
#include "DxfContent.h"

#include "PrintableName.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

namespace offmap::maps {

namespace {

/// By the value of $INSUNITS; those that no building is drawn in have no name here.
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

struct EntityKind {
    std::string_view type, kind;
};

constexpr std::array<EntityKind, 8> noWalls{{{"HATCH", "hatches"},
                                             {"MPOLYGON", "hatches"},
                                             {"DIMENSION", "dimensions"},
                                             {"ARC_DIMENSION", "dimensions"},
                                             {"LARGE_RADIAL_DIMENSION", "dimensions"},
                                             {"LEADER", "leaders"},
                                             {"MLEADER", "leaders"},
                                             {"MULTILEADER", "leaders"}}};

/// What GDAL draws, what belongs to it, and what is never a wall.
constexpr std::array<std::string_view, 34> known{
    "3DFACE",     "ARC",    "ATTDEF", "ATTRIB",    "BLOCK",    "CIRCLE",    "ELLIPSE",
    "ENDBLK",     "ENDSEC", "EOF",    "IMAGE",     "INSERT",   "LIGHT",     "LINE",
    "LWPOLYLINE", "MLINE",  "MTEXT",  "OLE2FRAME", "OLEFRAME", "POINT",     "POLYLINE",
    "SECTION",    "SEQEND", "SHAPE",  "SOLID",     "SPLINE",   "SUN",       "TEXT",
    "TOLERANCE",  "TRACE",  "VERTEX", "VIEWPORT",  "WIPEOUT",  "ACAD_TABLE"};

std::string_view trimmed(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    const size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(blanks) - begin + 1);
}

/// The lines of a DXF by twos: a code and what it codes.
class Pairs {
 public:
    explicit Pairs(std::string_view text) : text_(text) {}

    /// False at the end of the drawing. \throw std::runtime_error for a code that is no number:
    /// what follows would be taken for something else
    bool next() {
        if (place_ >= text_.size() || isEnd_) return false;
        code = line();
        value = line();
        isEnd_ = code == "0" && value == "EOF";
        const bool isCode = !code.empty() && code.find_first_not_of("-0123456789") == code.npos;
        if (isCode || (code.empty() && place_ >= text_.size())) return true;
        constexpr size_t first = 2;
        if (line_ == first) {
            throw std::runtime_error(
                "is no DXF by its content; give it the extension of what it is");
        }
        throw std::runtime_error(fmt::format("line {} is '{}', not a group code; export it anew",
                                             line_ - 1, printableName(code, 40)));
    }

    std::string_view code, value;

 private:
    std::string_view line() {
        const size_t begin = std::min(place_, text_.size());
        const size_t end = std::min(text_.find('\n', begin), text_.size());
        place_ = end + 1;
        ++line_;
        return trimmed(text_.substr(begin, end - begin));
    }

    std::string_view text_;
    size_t place_ = 0, line_ = 0;
    bool isEnd_ = false;
};

std::optional<DrawnUnit> unitOf(std::string_view code) {
    size_t value = 0;
    std::from_chars(code.data(), code.data() + code.size(), value);
    if (value >= units.size() || units.at(value).metres == 0) return std::nullopt;
    return units.at(value);
}

/// Notes an entity. \return whether it is no wall
bool note(std::string_view type, DxfContent& content) {
    const auto found = std::ranges::find(noWalls, type, &EntityKind::type);
    if (found != noWalls.end()) {
        ++content.leftOut[std::string(found->kind)];
        return true;
    }
    if (std::ranges::find(known, type) == known.end()) {
        ++content.unread[printableName(type, 40)];
    }
    return false;
}

void noteLayer(std::string_view name, DxfContent& content) {
    // others are in the drawing's own code page
    const bool isAscii = std::ranges::all_of(name, [](char c) { return c >= 0x20 && c < 0x7f; });
    std::string layer(name);
    if (isAscii && std::ranges::find(content.layers, layer) == content.layers.end()) {
        content.layers.push_back(std::move(layer));
    }
}

}  // namespace

DxfContent siftDxf(std::string& bytes) {
    if (bytes.starts_with("AutoCAD Binary DXF")) {
        throw std::runtime_error("is a binary DXF, which is not read; save it as ASCII DXF");
    }
    DxfContent content;
    Pairs pairs(bytes);
    std::string section;
    bool isUnit = false, isNoWall = false;
    while (pairs.next()) {
        const std::string_view code = pairs.code, value = pairs.value;
        const bool hasEntities = section == "ENTITIES" || section == "BLOCKS";
        if (code == "0") {
            isNoWall = hasEntities && note(value, content);
            // GDAL knows no entity of such a name
            if (isNoWall) bytes[static_cast<size_t>(value.data() - bytes.data())] = '_';
            if (value == "SECTION" || value == "ENDSEC") section = value;
        } else if (code == "2" && section == "SECTION") {
            section = value;
        } else if (code == "8" && isNoWall) {
            noteLayer(value, content);
        } else if (code == "70" && isUnit) {
            content.unit = unitOf(value);
        }
        isUnit = section == "HEADER" && code == "9" && value == "$INSUNITS";
    }
    if (section != "ENTITIES" && section != "BLOCKS") return content;
    throw std::runtime_error("is cut off: its section " + section +
                             " has no end; export or copy it anew");
}

}  // namespace offmap::maps
