// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/ArcWalls.h>
#include <offmap/maps/TextMap.h>

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

namespace offmap::maps {
namespace {

/// The fields of one kind of line; of the last three, sigma may stand alone.
struct LineForm {
    std::string_view keyword;                ///< its first word; empty: none
    std::array<std::string_view, 8> fields;  ///< their names
    size_t count;                            ///< of fields
    size_t geometry;                         ///< how many of them always stand there
};

constexpr LineForm wallForm{"", {"x1", "y1", "x2", "y2", "sigma", "z_min", "z_max"}, 7, 4};
constexpr LineForm arcForm{
    "arc", {"cx", "cy", "r", "start_deg", "end_deg", "sigma", "z_min", "z_max"}, 8, 5};
constexpr std::string_view forms =
    "a wall is: x1 y1 x2 y2 [sigma [z_min z_max]], or: "
    "arc cx cy r start_deg end_deg [sigma [z_min z_max]], in metres";
constexpr std::string_view blanks = " \t\r\v\f";

/// Where in which text; throws the messages.
struct Place {
    std::string_view name;
    size_t line = 0;  ///< from 1

    [[noreturn]] void fail(const std::string& found) const {
        throw std::runtime_error(fmt::format("{}:{}: {}; {}", name, line, found, forms));
    }
};

/// A field as it may be printed: in quotes, short, without control bytes.
std::string quoted(std::string_view field) {
    constexpr size_t maxShown = 40;
    std::string shown = "'";
    for (const char c : field.substr(0, maxShown)) {
        const auto byte = static_cast<unsigned char>(c);
        const bool printable = byte >= 0x20 && byte < 0x7f;
        shown += printable ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
    }
    return shown + (field.size() > maxShown ? "...'" : "'");
}

double parseNumber(std::string_view field, std::string_view name, const Place& place) {
    std::string_view digits = field;
    // std::from_chars knows no leading plus.
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
        place.fail(fmt::format("{} is {}, beyond what a number can hold", name, quoted(field)));
    if (error != std::errc{} || end != digits.data() + digits.size())
        place.fail(fmt::format("{} is {}, not a number", name, quoted(field)));
    if (!std::isfinite(value)) place.fail(fmt::format("{} is {}, not finite", name, quoted(field)));
    return value;
}

struct Fields {
    const LineForm* form = &wallForm;
    std::array<double, 8> values{};
    size_t count = 0;
};

void addField(Fields& fields, std::string_view field, const Place& place) {
    const LineForm& form = *fields.form;
    if (fields.count == form.count)
        place.fail(fmt::format("more than {0} fields, the {1}th is {2}", form.count, form.count + 1,
                               quoted(field)));
    fields.values[fields.count] = parseNumber(field, form.fields[fields.count], place);
    ++fields.count;
}

Fields parseFields(std::string_view line, const Place& place) {
    Fields fields;
    for (size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = line.find_first_not_of(blanks, begin)) {
        const size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        const std::string_view field = line.substr(begin, end - begin);
        const bool begins = fields.form == &wallForm && fields.count == 0;
        if (begins && field == arcForm.keyword) {
            fields.form = &arcForm;
        } else {
            addField(fields, field, place);
        }
        begin = end;
    }
    return fields;
}

void requireCount(const Fields& fields, const Place& place) {
    const size_t least = fields.form->geometry;
    if (fields.count == least || fields.count == least + 1 || fields.count == least + 3) return;
    const std::string_view whose = fields.form->keyword;
    place.fail(fmt::format("{} fields{}{}, but it takes {}, {} or {}", fields.count,
                           whose.empty() ? "" : " of an ", whose, least, least + 1, least + 3));
}

/// Sigma and height, which stand behind the geometry.
core::Wall wallLike(const Fields& fields, double defaultSigma, const Place& place) {
    const size_t least = fields.form->geometry;
    core::Wall wall;
    wall.sigma = fields.count > least ? fields.values[least] : defaultSigma;
    if (wall.sigma < 0) place.fail(fmt::format("sigma is {}, below zero", wall.sigma));
    if (fields.count == least + 3) {
        const double zMin = fields.values[least + 1], zMax = fields.values[least + 2];
        if (zMin > zMax) place.fail(fmt::format("z_min {} is above z_max {}", zMin, zMax));
        wall.height = {zMin, zMax};
    }
    return wall;
}

core::Wall straightWall(const Fields& fields, core::Wall wall, const Place& place) {
    const auto& v = fields.values;
    wall.line = {{v[0], v[1]}, {v[2], v[3]}};
    const double length = wall.line.length();
    if (!(length > 0)) place.fail("a wall without length");
    if (!std::isfinite(length)) place.fail("a wall of endless length");
    return wall;
}

/// Counter-clockwise from start to end, across 0 degrees where the end is the smaller number.
std::vector<core::Wall> arcWalls(const Fields& fields, const core::Wall& like, const Place& place) {
    const auto& [cx, cy, radius, start, end, sigma, zMin, zMax] = fields.values;
    double sweep = end - start;
    if (sweep < 0 && sweep > -360) sweep += 360;
    if (sweep < 0) place.fail("start_deg and end_deg lie a full circle or more apart");
    if (sweep == 0) place.fail("start_deg is end_deg; a full circle goes from 0 to 360");
    try {
        return core::wallsAlong(
            {{cx, cy}, radius, mrpt::DEG2RAD(std::remainder(start, 360)), mrpt::DEG2RAD(sweep)},
            like);
    } catch (const std::invalid_argument& e) {
        place.fail(e.what());
    }
}

void addWalls(const Fields& fields, double defaultSigma, const Place& place,
              std::vector<core::Wall>& walls) {
    requireCount(fields, place);
    const core::Wall like = wallLike(fields, defaultSigma, place);
    if (fields.form == &wallForm) {
        walls.push_back(straightWall(fields, like, place));
    } else {
        const auto pieces = arcWalls(fields, like, place);
        walls.insert(walls.end(), pieces.begin(), pieces.end());
    }
}

std::string readAll(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw std::runtime_error(
            fmt::format("{}: is a folder; name a text map: {}", file.string(), forms));
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::string text;
    try {
        in.exceptions(std::ios::badbit);  // a failing read would look like the end of the file
        if (in) text.assign(std::istreambuf_iterator<char>(in), {});
    } catch (const std::ios::failure&) {
        in.clear(std::ios::failbit);
    }
    if (in.fail() && !in.eof()) {
        const std::string why = std::generic_category().message(errno != 0 ? errno : EIO);
        throw std::runtime_error(fmt::format("{}: cannot read the map: {}", file.string(), why));
    }
    return text;
}

}  // namespace

std::vector<core::Wall> parseTextMap(std::string_view text, std::string_view name,
                                     double defaultSigma) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    std::vector<core::Wall> walls;
    Place place{name};
    for (size_t begin = text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
         begin < text.size();) {
        ++place.line;
        const size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        const Fields fields = parseFields(line.substr(0, line.find('#')), place);
        if (fields.count > 0 || fields.form == &arcForm)
            addWalls(fields, defaultSigma, place, walls);
        begin = end + 1;
    }
    if (walls.empty())
        throw std::runtime_error(fmt::format("{}: the map holds no wall; {}", name, forms));
    return walls;
}

std::vector<core::Wall> readTextMap(const std::filesystem::path& file, double defaultSigma) {
    return parseTextMap(readAll(file), file.string(), defaultSigma);
}

}  // namespace offmap::maps
