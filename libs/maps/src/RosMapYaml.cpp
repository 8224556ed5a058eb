// SPDX-License-Identifier: BSD-3-Clause
#include "PrintableName.h"

#include <offmap/maps/RosMap.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <yaml-cpp/yaml.h>

// The parser is yaml-cpp: mrpt::containers::yaml reports only some syntax errors, and otherwise
// returns what stood before them; of a repeated key it silently takes the last.

namespace offmap::maps {

namespace {

constexpr std::string_view example =
    "a ROS map is written as  image: map.pgm, resolution: 0.05, origin: [-10, -10, 0], negate: 0, "
    "occupied_thresh: 0.65, free_thresh: 0.196";

[[noreturn]] void refuse(const YAML::Mark& mark, const std::string& what) {
    throw YAML::Exception(mark, what);
}

double numberOf(const YAML::Node& node, std::string_view key) {
    const std::string text = node.IsScalar() ? node.Scalar() : "";
    double value = 0;
    const char *begin = text.data(), *end = begin + text.size();
    if (begin != end && *begin == '+') ++begin;  // std::from_chars knows none
    const auto [last, error] = std::from_chars(begin, end, value);
    if (text.empty() || error != std::errc{} || last != end || !std::isfinite(value)) {
        refuse(node.Mark(), fmt::format("{} is '{}', not a number", key, printableName(text, 40)));
    }
    return value;
}

mrpt::poses::CPose2D originOf(const YAML::Node& node) {
    constexpr size_t coordinates = 3;
    if (!node.IsSequence() || node.size() != coordinates) {
        refuse(node.Mark(), "origin takes three numbers: [x in m, y in m, yaw in rad]");
    }
    constexpr double mostMetres = 1e7;
    const double x = numberOf(node[0], "origin's x"), y = numberOf(node[1], "origin's y");
    if (std::abs(x) > mostMetres || std::abs(y) > mostMetres) {
        refuse(node.Mark(), fmt::format("origin is {:g}, {:g}, too far away in metres", x, y));
    }
    return {x, y, std::remainder(numberOf(node[2], "origin's yaw"), 2 * M_PI)};
}

bool flagOf(const YAML::Node& node) {
    bool value = false;
    if (node.IsScalar() && YAML::convert<bool>::decode(node, value)) return value;
    const double number = numberOf(node, "negate");
    if (number != 0 && number != 1) refuse(node.Mark(), "negate is 0 or 1");
    return number == 1;
}

RosMapMode modeOf(const YAML::Node& node) {
    const std::string word = node.IsScalar() ? node.Scalar() : "";
    if (word == "trinary") return RosMapMode::Trinary;
    if (word == "scale") return RosMapMode::Scale;
    if (word == "raw") return RosMapMode::Raw;
    refuse(node.Mark(),
           fmt::format("mode is '{}', but can be trinary, scale or raw", printableName(word, 40)));
}

void set(RosMapDescription& map, const std::string& key, const YAML::Node& value) {
    if (key == "image") {
        if (!value.IsScalar() || value.Scalar().empty()) {
            refuse(value.Mark(), "image is the name of the picture");
        }
        if (std::ranges::any_of(value.Scalar(), [](unsigned char c) { return c < 0x20; })) {
            refuse(value.Mark(), "image holds a control character");
        }
        map.image = value.Scalar();
    } else if (key == "resolution") {
        map.resolution = numberOf(value, key);
        if (map.resolution <= 0) refuse(value.Mark(), "resolution has to be above 0, in metres");
    } else if (key == "origin") {
        map.origin = originOf(value);
    } else if (key == "negate") {
        map.negate = flagOf(value);
    } else if (key == "occupied_thresh" || key == "free_thresh") {
        const double chance = numberOf(value, key);
        if (chance < 0 || chance > 1) refuse(value.Mark(), key + " is between 0 and 1");
        (key == "free_thresh" ? map.free : map.occupied) = chance;
    } else if (key == "mode") {
        map.mode = modeOf(value);
    } else {
        map.warnings.push_back(fmt::format("line {}: '{}' is not known and not used",
                                           value.Mark().line + 1, printableName(key, 40)));
    }
}

RosMapDescription descriptionOf(const std::string& text) {
    const YAML::Node map = YAML::Load(text);
    if (!map.IsMap()) refuse(map.Mark(), "no settings");
    RosMapDescription description;
    std::vector<std::string> seen;
    for (const auto& entry : map) {
        const YAML::Node &key = entry.first, &value = entry.second;
        if (!key.IsScalar()) refuse(key.Mark(), "a key must be plain text");
        if (std::ranges::find(seen, key.Scalar()) != seen.end()) {
            refuse(key.Mark(),
                   fmt::format("'{}' stands here a second time", printableName(key.Scalar(), 40)));
        }
        set(description, seen.emplace_back(key.Scalar()), value);
    }
    for (const char* needed : {"image", "resolution", "origin"}) {
        if (std::ranges::find(seen, needed) == seen.end()) {
            refuse(YAML::Mark::null_mark(), fmt::format("{} is missing", needed));
        }
    }
    if (description.free > description.occupied) {
        refuse(YAML::Mark::null_mark(), fmt::format("free_thresh {} is above occupied_thresh {}",
                                                    description.free, description.occupied));
    }
    return description;
}

}  // namespace

RosMapDescription parseRosMap(std::string_view text, const std::string& name) {
    try {
        return descriptionOf(std::string(text));
    } catch (const YAML::Exception& error) {
        const bool hasPlace = !error.mark.is_null();
        throw std::runtime_error(
            fmt::format("{}{}: {}; {}", name,
                        hasPlace ? fmt::format(":{}", error.mark.line + 1) : std::string(),
                        printableName(error.msg, 200), example));
    }
}

}  // namespace offmap::maps
