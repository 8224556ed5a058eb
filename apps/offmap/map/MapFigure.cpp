// SPDX-License-Identifier: BSD-3-Clause
#include "MapFigure.h"

#include "../PlainText.h"
#include "../TextSections.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/MapBounds.h>
#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace offmap::app {

namespace {

using view::PlanLegendEntry;

const mrpt::img::TColor others(150, 156, 165);

/// Layers by their length, the longest first.
std::vector<size_t> byLength(const maps::MapOfFile& map) {
    std::vector<size_t> order(map.layers.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::erase_if(order, [&](size_t i) { return map.layers[i].walls == 0; });
    std::ranges::stable_sort(
        order, [&](size_t a, size_t b) { return map.layers[a].length > map.layers[b].length; });
    return order;
}

std::string layerName(const maps::MapLayer& layer) {
    return layer.name.empty() ? "walls" : printable(layer.name);
}

/// [px] of a figure of 1600. Thin lines where there are many.
double strokeWidth(size_t walls) {
    return std::clamp(5.5 - std::log10(static_cast<double>(walls)), 1.0, 4.0);
}

/// "0.03 m", "0.01 to 0.05 m"
std::string sigmaText(const std::vector<core::Wall>& walls) {
    const auto [least, most] = std::ranges::minmax_element(walls, {}, &core::Wall::sigma);
    return least->sigma == most->sigma
               ? fmt::format("{:.3g} m", most->sigma)
               : fmt::format("{:.3g} to {:.3g} m", least->sigma, most->sigma);
}

/// Whether the bands of sigma show beside lines of that width [px of a figure of 1600].
bool showsBands(const std::vector<core::Wall>& walls, double width) {
    double sigma = 0;
    for (const core::Wall& wall : walls) sigma = std::max(sigma, wall.sigma);
    const auto [low, high] = maps::boundsOfAll(walls);
    const double size = std::max(high.x - low.x, high.y - low.y);
    return 2 * sigma * 1600 > (width + 3) * size;
}

bool isBounded(const core::Wall& wall) {
    return std::isfinite(wall.height.min()) || std::isfinite(wall.height.max());
}

void addLegend(const maps::MapOfFile& map, const std::vector<size_t>& order, size_t shown,
               view::PlanFigure& figure) {
    if (order.size() > 1 || !map.layers[order.front()].name.empty()) {
        for (size_t i = 0; i < shown; ++i) {
            const maps::MapLayer& layer = map.layers[order[i]];
            figure.legend.push_back(
                {fmt::format("{}, {:.0f} m", layerName(layer), layer.length), view::planColour(i)});
        }
    }
    if (shown < order.size()) {
        figure.legend.push_back({fmt::format("{} shorter layers", order.size() - shown), others});
    }
    if (std::ranges::any_of(figure.strokes, [](const auto& stroke) { return stroke.band > 0; })) {
        figure.legend.push_back({"± 1 sigma, " + sigmaText(map.walls), view::planColour(0),
                                 PlanLegendEntry::Mark::Band});
    }
    if (std::ranges::any_of(map.walls, isBounded)) {
        figure.legend.push_back(
            {"of limited height", view::planColour(0), PlanLegendEntry::Mark::DashedLine});
    }
}

}  // namespace

view::PlanFigure figureOf(const maps::MapOfFile& map, const std::string& name) {
    constexpr size_t mostColours = 10;
    const std::vector<size_t> order = byLength(map);
    const size_t shown = order.size() > mostColours ? mostColours - 1 : order.size();
    std::vector<mrpt::img::TColor> colourOf(map.layers.size(), others);
    for (size_t i = 0; i < shown; ++i) colourOf[order[i]] = view::planColour(i);

    view::PlanFigure figure;
    figure.title = printable(name);
    double length = 0;
    for (const maps::MapLayer& layer : map.layers) length += layer.length;
    figure.subtitle = fmt::format(
        "{}: {}, {} m, sigma {}", map.format, counted(map.walls.size(), "wall"),
        rawlog::grouped(static_cast<uint64_t>(std::llround(length))), sigmaText(map.walls));
    const double width = strokeWidth(map.walls.size());
    const bool bands = showsBands(map.walls, width);
    for (size_t i = 0; i < map.walls.size(); ++i) {
        figure.strokes.push_back({.wall = map.walls[i],
                                  .colour = colourOf[map.layerOf[i]],
                                  .width = width,
                                  .band = bands ? map.walls[i].sigma : 0,
                                  .dashed = isBounded(map.walls[i])});
    }
    addLegend(map, order, shown, figure);
    return figure;
}

}  // namespace offmap::app
