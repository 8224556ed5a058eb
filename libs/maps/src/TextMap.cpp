// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/maps/TextMap.h>

#include <fmt/format.h>

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

constexpr std::array fieldNames{"x1", "y1", "x2", "y2", "sigma", "z_min", "z_max"};
constexpr std::string_view lineForm = "a wall is: x1 y1 x2 y2 [sigma [z_min z_max]], in metres";

/// Where in which text; throws the messages.
struct Place {
    std::string_view name;
    size_t line = 0;  ///< from 1

    [[noreturn]] void fail(const std::string& found) const {
        throw std::runtime_error(fmt::format("{}:{}: {}; {}", name, line, found, lineForm));
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

double parseNumber(std::string_view field, size_t index, const Place& place) {
    std::string_view digits = field;
    // std::from_chars knows no leading plus.
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
        place.fail(fmt::format("{} is {}, beyond what a number can hold", fieldNames[index],
                               quoted(field)));
    if (error != std::errc{} || end != digits.data() + digits.size())
        place.fail(fmt::format("{} is {}, not a number", fieldNames[index], quoted(field)));
    if (!std::isfinite(value))
        place.fail(fmt::format("{} is {}, not finite", fieldNames[index], quoted(field)));
    return value;
}

struct Fields {
    std::array<double, fieldNames.size()> values{};
    size_t count = 0;
};

Fields parseFields(std::string_view line, const Place& place) {
    constexpr std::string_view blanks = " \t\r\v\f";
    Fields fields;
    for (size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = line.find_first_not_of(blanks, begin)) {
        const size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        if (fields.count == fieldNames.size())
            place.fail(fmt::format("more than 7 fields, the 8th is {}",
                                   quoted(line.substr(begin, end - begin))));
        fields.values[fields.count] =
            parseNumber(line.substr(begin, end - begin), fields.count, place);
        ++fields.count;
        begin = end;
    }
    return fields;
}

core::Wall toWall(const Fields& fields, double defaultSigma, const Place& place) {
    if (fields.count != 4 && fields.count != 5 && fields.count != 7)
        place.fail(fmt::format("{} fields, but it takes 4, 5 or 7", fields.count));
    const auto& [x1, y1, x2, y2, sigma, zMin, zMax] = fields.values;
    core::Wall wall;
    wall.line = {{x1, y1}, {x2, y2}};
    wall.sigma = fields.count > 4 ? sigma : defaultSigma;
    const double length = wall.line.length();
    if (!(length > 0)) place.fail("a wall without length");
    if (!std::isfinite(length)) place.fail("a wall of endless length");
    if (wall.sigma < 0) place.fail(fmt::format("sigma is {}, below zero", wall.sigma));
    if (fields.count == 7) {
        if (zMin > zMax) place.fail(fmt::format("z_min {} is above z_max {}", zMin, zMax));
        wall.height = {zMin, zMax};
    }
    return wall;
}

std::string readAll(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw std::runtime_error(
            fmt::format("{}: is a folder; name a text map: {}", file.string(), lineForm));
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
        if (fields.count > 0) walls.push_back(toWall(fields, defaultSigma, place));
        begin = end + 1;
    }
    if (walls.empty())
        throw std::runtime_error(fmt::format("{}: the map holds no wall; {}", name, lineForm));
    return walls;
}

std::vector<core::Wall> readTextMap(const std::filesystem::path& file, double defaultSigma) {
    return parseTextMap(readAll(file), file.string(), defaultSigma);
}

std::vector<core::Wall> placed(std::vector<core::Wall> walls,
                               const mrpt::poses::CPose2D& mapOrigin) {
    for (core::Wall& wall : walls) {
        const mrpt::math::TSegment2D line = wall.line;
        mapOrigin.composePoint(line.point1, wall.line.point1);
        mapOrigin.composePoint(line.point2, wall.line.point2);
    }
    return walls;
}

}  // namespace offmap::maps
