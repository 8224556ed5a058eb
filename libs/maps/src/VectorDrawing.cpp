// SPDX-License-Identifier: BSD-3-Clause
#include "GdalSession.h"
#include "LineArcs.h"
#include "LineReader.h"
#include "PlanePlacement.h"
#include "PlausibleSize.h"
#include "VectorFormat.h"

#include <offmap/maps/VectorDrawing.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>

namespace offmap::maps {

namespace {

/// What of one kind was dropped, and the first of it.
struct Dropped {
    size_t count = 0;
    std::string first;

    void add(const DrawnLines& lines, const DrawnLines::Line& line) {
        if (count++ > 0) return;
        first = fmt::format("feature {} of layer {}", line.feature, lines.layers[line.layer]);
    }
    void warn(Drawing& drawing, std::string_view what) const {
        if (count == 0) return;
        drawing.warnings.push_back(fmt::format("{} {}; the first is {}", count, what, first));
    }
};

bool isPlace(const mrpt::math::TPoint2D& point) {
    constexpr double farthest = 1e9;  // [m] beyond it a micrometre is lost
    return std::abs(point.x) <= farthest && std::abs(point.y) <= farthest;
}

class WallMaker {
 public:
    WallMaker(const DrawnLines& lines, double sigma, Drawing& drawing)
        : lines_(lines), sigma_(sigma), drawing_(drawing) {}

    void make() {
        drawing_.layers = lines_.layers;
        for (const auto& line : lines_.lines) add(line);
        endless_.warn(drawing_, "lines have places that are not finite, which are left out");
        lengthless_.warn(drawing_, "lines without length are left out");
        if (upright_ > 0) {
            drawing_.notes.push_back(
                fmt::format("left out: {} upright lines, which are points from above", upright_));
        }
    }

 private:
    void add(const DrawnLines::Line& line) {
        core::Wall like;
        like.sigma = line.sigma.value_or(sigma_);
        like.height = line.height;
        const size_t before = drawing_.walls.size();
        bool isFinite = true;
        for (size_t begin = line.begin; begin < line.end;) {
            size_t end = begin;
            while (end < line.end && isPlace(lines_.points[end])) ++end;
            isFinite = isFinite && end == line.end;
            const auto places = std::span(lines_.points).subspan(begin, end - begin);
            for (const auto& wall : wallsThrough(places, like)) drawing_.add(wall, line.layer);
            begin = end + 1;
        }
        if (!isFinite) return endless_.add(lines_, line);
        if (drawing_.walls.size() > before) return;
        if (line.rises) ++upright_;
        if (!line.rises) lengthless_.add(lines_, line);
    }

    const DrawnLines& lines_;
    double sigma_;
    Drawing& drawing_;
    Dropped endless_, lengthless_;
    size_t upright_ = 0;
};

std::string leftOut(const DrawnLines& lines) {
    std::vector<std::string> kinds;
    for (const auto& [what, count] : lines.leftOut) {
        kinds.push_back(fmt::format("{} ({})", what, count));
    }
    return fmt::format("{}", fmt::join(kinds, ", "));
}

void judgeExtent(Extent extent, bool isProjected, double scale, Drawing& drawing) {
    if (const auto note = farNote(extent)) drawing.notes.push_back(*note);
    extent.low *= scale;
    extent.high *= scale;
    if (const auto warning = sizeWarning(extent, isProjected)) drawing.warnings.push_back(*warning);
}

Drawing drawingOf(DrawnLines lines, const VectorFormat& format, const MapOptions& options) {
    Drawing drawing;
    drawing.format = format.name;
    drawing.isDrawnByHand = true;
    drawing.warnings = lines.warnings;
    const bool isProjected = placeInPlane(lines, format.kind, options, drawing);
    WallMaker(lines, options.sigma, drawing).make();
    if (!lines.leftOut.empty()) drawing.notes.push_back("left out: " + leftOut(lines));
    if (lines.hasHeights) {
        drawing.notes.emplace_back(
            "heights (z) of its places are dropped; layer rules set heights");
    }
    judgeExtent(extentOf(lines.points), isProjected, options.scale, drawing);
    if (!drawing.walls.empty()) return drawing;
    std::string why = "the map holds no wall: no line, polygon or arc of it could be one";
    if (!lines.leftOut.empty()) why += "; left out: " + leftOut(lines);
    for (const std::string& warning : drawing.warnings) why += "; " + warning;
    throw std::runtime_error(why);
}

}  // namespace

std::vector<std::string_view> vectorExtensions() {
    std::vector<std::string_view> all;
    for (const VectorFormat& format : vectorFormats()) {
        all.insert(all.end(), format.extensions.begin(), format.extensions.end());
    }
    return all;
}

Drawing readVectorDrawing(const std::filesystem::path& file, const MapOptions& options) {
    try {
        const VectorFormat& format = vectorFormatOf(file);
        const GdalSession session;
        return drawingOf(readLines(file, format, options, session), format, options);
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}  // namespace offmap::maps
