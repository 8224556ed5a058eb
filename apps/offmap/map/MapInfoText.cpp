// SPDX-License-Identifier: BSD-3-Clause
#include "../PlainText.h"
#include "../TextSections.h"
#include "MapFacts.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace offmap::app {

using rawlog::grouped;

namespace {

/// "0.06 m", "12.3 m", "5,000 m"
std::string lengthText(double metres) {
    return metres < 1000 ? fmt::format("{:.3g} m", metres)
                         : grouped(static_cast<uint64_t>(std::llround(metres))) + " m";
}

std::vector<std::string> wallLines(const MapFacts& facts) {
    const size_t count = facts.map.walls.size();
    const std::string arcs = facts.arcs == 0 ? ""
                             : facts.straight == 0
                                 ? " (all arcs)"
                                 : fmt::format(" ({} of them arcs)", grouped(facts.arcs));
    std::vector<std::string> lines{
        fmt::format("{}{}, {:.1f} m in all", grouped(count), arcs, facts.length)};
    if (count > 1) {
        lines.push_back(fmt::format("{} to {} long, half of them above {}",
                                    lengthText(facts.shortest), lengthText(facts.longest),
                                    lengthText(facts.medianLength)));
    }
    return lines;
}

std::string heightText(const MapFacts& facts) {
    if (facts.bounded == 0) return "all walls from everywhere to everywhere";
    std::string text = fmt::format("{} of limited height", counted(facts.bounded, "wall"));
    if (facts.lowest) text += fmt::format(", from z {:.2f} m", *facts.lowest);
    if (facts.highest) text += fmt::format(", up to z {:.2f} m", *facts.highest);
    return text;
}

std::string sigmaText(const MapFacts& facts) {
    return facts.leastSigma == facts.largestSigma
               ? fmt::format("{:.3g} m", facts.leastSigma)
               : fmt::format("{:.3g} to {:.3g} m", facts.leastSigma, facts.largestSigma);
}

/// How many letters stand in a text, which is UTF-8.
size_t lettersIn(const std::string& text) {
    return static_cast<size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string layerSection(const MapFacts& facts) {
    const auto& layers = facts.map.layers;
    if (layers.size() == 1 && layers.front().name.empty()) return "";
    size_t width = 4;
    for (const auto& layer : layers) width = std::max(width, lettersIn(nameOf(layer.name)));
    std::vector<std::string> lines{
        fmt::format("{:<{}} {:>9} {:>9} {:>11}", "name", width, "lines", "walls", "length")};
    for (const auto& layer : layers) {
        const std::string name = layer.name.empty() ? "(no name)" : printable(layer.name);
        const std::string gap(width - std::min(width, lettersIn(name)), ' ');
        lines.push_back(layer.used
                            ? fmt::format("{}{} {:>9} {:>9} {:>9.1f} m", name, gap,
                                          grouped(layer.lines), grouped(layer.walls), layer.length)
                            : fmt::format("{}{} {:>9}  left out", name, gap, grouped(layer.lines)));
    }
    return section("layers", lines);
}

std::string sentences(std::string_view key, const std::vector<std::string>& all) {
    std::vector<std::string> lines;
    for (const std::string& sentence : all) {
        const auto more = wrapped("- " + printable(sentence), 2);
        lines.insert(lines.end(), more.begin(), more.end());
    }
    return section(key, lines);
}

}  // namespace

std::string mapInfoText(const MapFacts& facts) {
    const double width = facts.high.x - facts.low.x, depth = facts.high.y - facts.low.y;
    return section("map",
                   {fmt::format("{}: {}", printable(facts.file.string()), facts.map.format)}) +
           section("extent", {fmt::format("{:.2f} m by {:.2f} m: x {:.2f} to {:.2f}, y {:.2f} to "
                                          "{:.2f}",
                                          width, depth, facts.low.x, facts.high.x, facts.low.y,
                                          facts.high.y)}) +
           section("walls", wallLines(facts)) + section("sigma", {sigmaText(facts)}) +
           section("height", {heightText(facts)}) + layerSection(facts) +
           sentences("notes", facts.map.notes) + sentences("warnings", facts.warnings);
}

}  // namespace offmap::app
