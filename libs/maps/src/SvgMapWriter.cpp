// SPDX-License-Identifier: BSD-3-Clause
#include "SvgAttributes.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/MapBounds.h>
#include <offmap/maps/SvgMapWriter.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace offmap::maps {

namespace {

using mrpt::math::TPoint2D;

/// The sheet, in the map's axes: its lower left and upper right corner.
core::WallBounds sheetFor(std::span<const core::Wall> walls) {
    if (walls.empty()) return {{0, 0}, {1, 1}};
    const core::WallBounds all = boundsOfAll(walls);
    // a margin, to decimetres, so that coordinates keep their digits
    const auto below = [](double value) { return (std::floor(10 * value) - 1) / 10; };
    const auto above = [](double value) { return (std::ceil(10 * value) + 1) / 10; };
    return {{below(all.low.x), below(all.low.y)}, {above(all.high.x), above(all.high.y)}};
}

/// As SVG has it: from the sheet's upper left corner, y down.
std::string placeText(const TPoint2D& place, const core::WallBounds& sheet) {
    return fmt::format("{:.5f},{:.5f}", place.x - sheet.low.x, sheet.high.y - place.y);
}

std::string stepTo(const core::Wall& wall, const std::string& end) {
    if (wall.curvature == 0) return " L" + end;
    // y down turns a bend to the left into one to the right: the sweep flag is 1 for that
    return fmt::format(" A{0:.9g},{0:.9g} 0 0 {1} {2}", 1 / std::abs(wall.curvature),
                       wall.curvature > 0 ? 0 : 1, end);
}

void describe(pugi::xml_node path, const core::Wall& wall) {
    path.append_attribute(svg::sigma) = fmt::format("{:.9g}", wall.sigma).c_str();
    if (std::isfinite(wall.height.min()))
        path.append_attribute(svg::zMin) = fmt::format("{:.9g}", wall.height.min()).c_str();
    if (std::isfinite(wall.height.max()))
        path.append_attribute(svg::zMax) = fmt::format("{:.9g}", wall.height.max()).c_str();
}

bool areAlike(const core::Wall& a, const core::Wall& b) {
    return a.sigma == b.sigma && a.height.min() == b.height.min() &&
           a.height.max() == b.height.max();
}

/// One path for walls that follow each other.
void drawWalls(pugi::xml_node layer, const std::vector<const core::Wall*>& walls,
               const core::WallBounds& sheet) {
    for (size_t i = 0; i < walls.size();) {
        const core::Wall& first = *walls[i];
        std::string end = placeText(first.line.point1, sheet), steps = "M" + end;
        for (; i < walls.size() && areAlike(first, *walls[i]); ++i) {
            if (placeText(walls[i]->line.point1, sheet) != end) break;
            end = placeText(walls[i]->line.point2, sheet);
            steps += stepTo(*walls[i], end);
        }
        auto path = layer.append_child("path");
        path.append_attribute("d") = steps.c_str();
        describe(path, first);
    }
}

pugi::xml_node addSheet(pugi::xml_document& document, const core::WallBounds& sheet) {
    const double width = sheet.high.x - sheet.low.x, height = sheet.high.y - sheet.low.y;
    auto root = document.append_child("svg");
    root.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
    root.append_attribute("xmlns:inkscape") = "http://www.inkscape.org/namespaces/inkscape";
    root.append_attribute("width") = fmt::format("{:.1f}mm", 1000 * width).c_str();
    root.append_attribute("height") = fmt::format("{:.1f}mm", 1000 * height).c_str();
    root.append_attribute("viewBox") = fmt::format("0 0 {:.4f} {:.4f}", width, height).c_str();
    root.append_attribute(svg::lowerLeft) =
        fmt::format("{:.4f} {:.4f}", sheet.low.x, sheet.low.y).c_str();
    return root;
}

/// Layers in the order in which the walls name them.
std::vector<std::pair<std::string, std::vector<const core::Wall*>>> byLayer(
    std::span<const core::Wall> walls, std::span<const std::string> layerOfEach) {
    std::vector<std::pair<std::string, std::vector<const core::Wall*>>> layers;
    std::map<std::string_view, size_t> places;
    for (size_t i = 0; i < walls.size(); ++i) {
        const auto [found, isNew] = places.try_emplace(layerOfEach[i], layers.size());
        if (isNew) layers.push_back({layerOfEach[i], {}});
        layers[found->second].second.push_back(&walls[i]);
    }
    return layers;
}

}  // namespace

std::string svgMapOf(std::span<const core::Wall> walls, std::span<const std::string> layerOfEach) {
    if (walls.size() != layerOfEach.size())
        throw std::invalid_argument("svgMapOf: a layer's name is needed for each wall");
    const core::WallBounds sheet = sheetFor(walls);
    pugi::xml_document document;
    auto root = addSheet(document, sheet);
    for (const auto& [name, ofLayer] : byLayer(walls, layerOfEach)) {
        auto layer = root.append_child("g");
        if (!name.empty()) {
            layer.append_attribute(svg::groupMode) = "layer";
            layer.append_attribute(svg::label) = name.c_str();
        }
        layer.append_attribute("style") = "fill:none;stroke:#000000;stroke-width:0.02";
        drawWalls(layer, ofLayer, sheet);
    }
    std::ostringstream text;
    document.save(text, " ");
    return text.str();
}

}  // namespace offmap::maps
