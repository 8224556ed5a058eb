// SPDX-License-Identifier: BSD-3-Clause
#include "MapFacts.h"

#include "MapSmells.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/MapBounds.h>

#include <algorithm>
#include <cmath>

namespace offmap::app {

namespace {

void addHeights(const core::Wall& wall, MapFacts& facts) {
    const double low = wall.height.min(), high = wall.height.max();
    if (!std::isfinite(low) && !std::isfinite(high)) return;
    ++facts.bounded;
    if (std::isfinite(low)) facts.lowest = std::min(low, facts.lowest.value_or(low));
    if (std::isfinite(high)) facts.highest = std::max(high, facts.highest.value_or(high));
}

void addLengths(std::vector<double> lengths, MapFacts& facts) {
    const auto [least, most] = std::ranges::minmax_element(lengths);
    facts.shortest = *least;
    facts.longest = *most;
    for (const double length : lengths) facts.length += length;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    facts.medianLength = *middle;
}

}  // namespace

MapFacts factsOf(maps::MapOfFile map, const std::filesystem::path& file) {
    MapFacts facts;
    facts.file = file;
    facts.map = std::move(map);
    const std::vector<core::Wall>& walls = facts.map.walls;
    const core::WallBounds bounds = maps::boundsOfAll(walls);
    facts.low = bounds.low;
    facts.high = bounds.high;
    std::vector<double> lengths;
    for (const core::Wall& wall : walls) {
        ++(wall.curvature == 0 ? facts.straight : facts.arcs);
        lengths.push_back(core::lengthOf(wall));
        addHeights(wall, facts);
    }
    const auto [least, most] = std::ranges::minmax_element(walls, {}, &core::Wall::sigma);
    facts.leastSigma = least->sigma;
    facts.largestSigma = most->sigma;
    addLengths(std::move(lengths), facts);
    facts.warnings = facts.map.warnings;
    for (std::string& smell : smellsOf(facts)) facts.warnings.push_back(std::move(smell));
    return facts;
}

}  // namespace offmap::app
