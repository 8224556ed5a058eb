// SPDX-License-Identifier: BSD-3-Clause
#include "SvgWalk.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/MapBounds.h>
#include <offmap/maps/SvgMap.h>

#include <fmt/format.h>
#include <mrpt/io/CFileGZInputStream.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>

namespace offmap::maps {

namespace {

constexpr size_t largest = size_t{1} << 29;  // bytes

size_t lineAt(std::string_view text, ptrdiff_t offset) {
    const auto end = std::min(static_cast<size_t>(std::max<ptrdiff_t>(offset, 0)), text.size());
    return 1 + static_cast<size_t>(std::ranges::count(text.substr(0, end), '\n'));
}

/// "<path id="wall7">"
std::string described(const pugi::xml_node& element) {
    const std::string_view id = element.attribute("id").value();
    return id.empty() ? fmt::format("<{}>", element.name())
                      : fmt::format("<{} id=\"{:.40}\">", element.name(), id);
}

pugi::xml_node rootOf(const pugi::xml_document& document, std::string_view name) {
    const pugi::xml_node root = document.document_element();
    const std::string_view element = root.name();
    if (element.substr(element.find(':') + 1) == "svg") return root;
    throw std::runtime_error(fmt::format(
        "{}: no SVG drawing: its outermost element is <{:.40}>, not <svg>", name, element));
}

/// A plan may be drawn as large as its paper.
void warnOfPaper(const MapOptions& options, Drawing& drawing) {
    if (options.units || options.scale != 1 || drawing.walls.empty()) return;
    const core::WallBounds all = boundsOfAll(drawing.walls);
    const double width = all.high.x - all.low.x, height = all.high.y - all.low.y;
    constexpr double smallestRoom = 2;  // [m]
    if (std::max(width, height) >= smallestRoom) return;
    drawing.warnings.push_back(
        fmt::format("the map is {:.3g} m wide and {:.3g} m high; a plan on paper? Give its scale, "
                    "as --map-scale 100 for 1:100, or what a user unit is, as --map-units cm",
                    width, height));
}

std::string readAll(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored) || !std::ifstream(file)) {
        throw std::runtime_error(
            fmt::format("{}: cannot be read; is it there and a file?", file.string()));
    }
    if (std::filesystem::file_size(file, ignored) == 0) {
        throw std::runtime_error(fmt::format("{}: the file is empty", file.string()));
    }
    mrpt::io::CFileGZInputStream stream(file.string());
    std::string text;
    std::array<char, 65536> part{};
    for (size_t count = 1; count > 0;) {
        count = stream.Read(part.data(), part.size());
        text.append(part.data(), count);
        if (text.size() > largest) {
            throw std::runtime_error(
                fmt::format("{}: more than {} MiB of drawing; leave out what is no wall",
                            file.string(), largest >> 20));
        }
    }
    return text;
}

}  // namespace

Drawing parseSvgMap(std::string_view text, std::string_view name, const MapOptions& options) {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) {
        throw std::runtime_error(fmt::format("{}:{}: no valid XML: {}", name,
                                             lineAt(text, parsed.offset), parsed.description()));
    }
    Drawing drawing;
    drawing.format = "SVG";
    drawing.isDrawnByHand = true;
    svg::Walk walk(rootOf(document, name), options, drawing);
    try {
        walk.run();
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(fmt::format("{}:{}: {}: {}", name,
                                             lineAt(text, walk.last().offset_debug()),
                                             described(walk.last()), e.what()));
    }
    if (drawing.walls.empty()) {
        throw std::runtime_error(
            fmt::format("{}: the drawing shows no line{}{}; text and pictures cannot be read", name,
                        drawing.notes.size() > 1 ? "; " : "",
                        drawing.notes.size() > 1 ? drawing.notes[1] : ""));
    }
    warnOfPaper(options, drawing);
    return drawing;
}

Drawing readSvgMap(const std::filesystem::path& file, const MapOptions& options) {
    return parseSvgMap(readAll(file), file.string(), options);
}

}  // namespace offmap::maps
