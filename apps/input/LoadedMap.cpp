// SPDX-License-Identifier: BSD-3-Clause
#include "LoadedMap.h"

#include "GuardedMap.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace offmap::app {

std::string describe(const maps::MapOfFile& map, const std::string& file) {
    std::vector<std::string> used, unused;
    double length = 0;
    for (const maps::MapLayer& layer : map.layers) {
        if (!layer.name.empty()) (layer.used ? used : unused).push_back(layer.name);
        length += layer.length;
    }
    std::string text =
        fmt::format("{}: {} wall{}, {:.1f} m", file, rawlog::grouped(map.walls.size()),
                    map.walls.size() == 1 ? "" : "s", length);
    constexpr size_t most = 6;
    if (!used.empty() && used.size() <= most) {
        text += fmt::format(", layer{} {}", used.size() == 1 ? "" : "s", fmt::join(used, ", "));
    } else if (!used.empty()) {
        text += fmt::format(", {} layers", used.size());
    }
    if (!unused.empty()) {
        const bool few = unused.size() <= most;
        text += fmt::format(" ({} left out{}{})", unused.size(), few ? ": " : "",
                            few ? fmt::format("{}", fmt::join(unused, ", ")) : "");
    }
    return text;
}

LoadedMap loadedMapOf(maps::MapOfFile map, const std::string& file) {
    std::string description = describe(map, file);
    return {core::LineMap(std::move(map.walls)), std::move(map.format), std::move(description),
            std::move(map.notes), std::move(map.warnings)};
}

LoadedMap loadMap(const std::filesystem::path& file, const maps::MapOptions& options) {
    return loadedMapOf(readMapGuarded(file, options), file.string());
}

std::string summaryOf(const LoadedMap& map) {
    std::string text = fmt::format("map     {}\n", map.description);
    for (const std::string& note : map.notes) text += fmt::format("        {}\n", note);
    return text;
}

}  // namespace offmap::app
