// SPDX-License-Identifier: BSD-3-Clause
#include "PackedMap.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

namespace offmap::app {

namespace {

using nlohmann::json;

template <class Value>
void append(const std::vector<Value>& values, Bytes& bytes) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* begin = reinterpret_cast<const uint8_t*>(values.data());
    bytes.insert(bytes.end(), begin, begin + values.size() * sizeof(Value));
}

/// Takes values off the front.
template <class Value>
std::vector<Value> take(size_t count, const Value& like, std::span<const uint8_t>& bytes) {
    std::vector<Value> values(count, like);
    const auto taken = bytes.first(count * sizeof(Value));
    if (count > 0) std::memcpy(values.data(), taken.data(), taken.size());
    bytes = bytes.subspan(taken.size());
    return values;
}

}  // namespace

Bytes packed(const maps::MapOfFile& map) {
    json layers = json::array();
    for (const maps::MapLayer& layer : map.layers) {
        layers.push_back({layer.name, layer.lines, layer.walls, layer.length, layer.used});
    }
    const json head{{"format", map.format},
                    {"notes", map.notes},
                    {"warnings", map.warnings},
                    {"layers", layers},
                    {"walls", map.walls.size()}};
    // Names come from the file, in whatever encoding.
    const std::string text = head.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
    Bytes bytes(text.begin(), text.end());
    append(map.walls, bytes);
    append(map.layerOf, bytes);
    return bytes;
}

maps::MapOfFile unpacked(std::span<const uint8_t> bytes) {
    const auto end = std::find(bytes.begin(), bytes.end(), uint8_t{'\n'});
    const json head = json::parse(bytes.begin(), end);
    bytes = bytes.subspan(static_cast<size_t>(end - bytes.begin()) + 1);
    maps::MapOfFile map;
    map.format = head["format"];
    map.notes = head["notes"];
    map.warnings = head["warnings"];
    for (const json& layer : head["layers"]) {
        map.layers.push_back({layer[0], layer[1], layer[2], layer[3], layer[4]});
    }
    const size_t walls = head["walls"];
    map.walls = take(walls, core::Wall{}, bytes);
    map.layerOf = take(walls, uint32_t{0}, bytes);
    return map;
}

}  // namespace offmap::app
