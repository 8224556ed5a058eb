// SPDX-License-Identifier: BSD-3-Clause
#include "MapFacts.h"

#include <nlohmann/json.hpp>

namespace offmap::app {

using nlohmann::ordered_json;

namespace {

ordered_json orNull(const std::optional<double>& number) {
    return number ? ordered_json(*number) : ordered_json();
}

}  // namespace

std::string mapInfoJson(const MapFacts& facts) {
    ordered_json out;
    out["offmap"] = OFFMAP_VERSION;
    out["file"] = facts.file.string();
    out["format"] = facts.map.format;
    out["extent"] = {{"x_min_m", facts.low.x},
                     {"x_max_m", facts.high.x},
                     {"y_min_m", facts.low.y},
                     {"y_max_m", facts.high.y}};
    out["walls"] = facts.map.walls.size();
    out["arcs"] = facts.arcs;
    out["length_m"] = facts.length;
    out["shortest_m"] = facts.shortest;
    out["median_m"] = facts.medianLength;
    out["longest_m"] = facts.longest;
    out["sigma_min_m"] = facts.leastSigma;
    out["sigma_max_m"] = facts.largestSigma;
    out["walls_of_limited_height"] = facts.bounded;
    out["z_min_m"] = orNull(facts.lowest);
    out["z_max_m"] = orNull(facts.highest);
    out["layers"] = ordered_json::array();
    for (const maps::MapLayer& layer : facts.map.layers) {
        out["layers"].push_back({{"name", layer.name},
                                 {"used", layer.used},
                                 {"lines", layer.lines},
                                 {"walls", layer.walls},
                                 {"length_m", layer.length}});
    }
    out["notes"] = facts.map.notes;
    out["warnings"] = facts.warnings;
    // Names come from the file, in whatever encoding.
    return out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace offmap::app
