// SPDX-License-Identifier: BSD-3-Clause
#include "PlanPainter.h"

#include <offmap/core/WallGeometry.h>

#include <algorithm>
#include <cmath>

namespace offmap::view {

namespace {

using mrpt::img::TColor;
using mrpt::math::TPoint2D;
using Align = PlanCanvas::Align;

const TColor paper(255, 255, 255), gridLine(232, 235, 239), axis(90, 98, 110), ink(24, 30, 40),
    faint(96, 104, 116);

/// The colour mixed with the paper's, as if it were transparent: what overlaps is not darker.
TColor lighter(const TColor& colour) {
    const auto mix = [](uint8_t c) { return static_cast<uint8_t>(255 - (255 - c) / 4); };
    return {mix(colour.R), mix(colour.G), mix(colour.B)};
}

}  // namespace

void PlanPainter::paint() {
    canvas_.colour(paper);
    canvas_.fill(0, 0, layout_.width, layout_.height);
    paintGrid();
    for (const bool bands : {true, false}) paintStrokes(bands);
    for (const PlanDot& dot : figure_.dots) {
        canvas_.colour(dot.colour);
        canvas_.disc(layout_.pixelOf(dot.place), px(dot.radius));
    }
    paintTitle();
    paintAxes();
    paintScale();
    paintLegend();
    canvas_.finish();
}

void PlanPainter::paintGrid() {
    canvas_.width(std::max(1.0, px(1)));
    canvas_.colour(gridLine);
    for (const double x : ticksBetween(layout_.low.x, layout_.high.x, layout_.tickStep)) {
        const double at = layout_.pixelOf({x, 0}).x;
        canvas_.line({at, layout_.top}, {at, bottom()});
    }
    for (const double y : ticksBetween(layout_.low.y, layout_.high.y, layout_.tickStep)) {
        const double at = layout_.pixelOf({0, y}).y;
        canvas_.line({layout_.left, at}, {right(), at});
    }
}

std::vector<TPoint2D> PlanPainter::pixelsAlong(const core::Wall& wall) const {
    if (wall.curvature == 0) {
        return {layout_.pixelOf(wall.line.point1), layout_.pixelOf(wall.line.point2)};
    }
    // n chords of an arc of length l and turn a miss it by at most l a / (8 n^2)
    constexpr double missed = 0.05;  // [px]
    const double length = core::lengthOf(wall), turn = std::abs(length * wall.curvature);
    const double chords =
        std::ceil(std::sqrt(length * layout_.pixelsPerMetre * turn / (8 * missed)));
    std::vector<TPoint2D> points;
    for (double i = 0; i <= std::max(1.0, chords); ++i) {
        points.push_back(layout_.pixelOf(core::placeAt(wall, i / std::max(1.0, chords))));
    }
    return points;
}

/// Neighbours that look alike in one path, which is quick to draw and short in an SVG; not too
/// many, for then Cairo takes long to find out where they cross.
void PlanPainter::paintStrokes(bool bands) {
    constexpr size_t mostInAPath = 500;
    const auto& strokes = figure_.strokes;
    const auto alike = [&](const PlanStroke& a, const PlanStroke& b) {
        return a.colour == b.colour && a.dashed == b.dashed &&
               (bands ? a.band == b.band : a.width == b.width);
    };
    for (size_t i = 0; i < strokes.size();) {
        const size_t begin = i;
        for (; i < strokes.size() && i - begin < mostInAPath && alike(strokes[i], strokes[begin]);
             ++i) {
            if (!bands || strokes[i].band > 0) canvas_.path(pixelsAlong(strokes[i].wall));
        }
        const PlanStroke& stroke = strokes[begin];
        canvas_.colour(bands ? lighter(stroke.colour) : stroke.colour);
        canvas_.width(bands ? 2 * stroke.band * layout_.pixelsPerMetre : px(stroke.width));
        if (stroke.dashed && !bands) canvas_.dashes(px(3 * stroke.width), px(3 * stroke.width));
        canvas_.stroke();
        canvas_.solid();
    }
}

void PlanPainter::paintTitle() {
    using namespace plan_style;
    canvas_.letters(px(titleLetters), true);
    canvas_.colour(ink);
    canvas_.text(fitting(figure_.title), px(32), px(52));
    canvas_.letters(px(subtitleLetters));
    canvas_.colour(faint);
    canvas_.text(fitting(figure_.subtitle), px(32), px(86));
}

/// Cut at its end where it is wider than the figure.
std::string PlanPainter::fitting(std::string text) {
    const double room = layout_.width - px(64);
    if (canvas_.widthOf(text) <= room) return text;
    while (!text.empty() && canvas_.widthOf(text + "…") > room) {
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) {
            text.pop_back();  // the later bytes of a letter
        }
        if (!text.empty()) text.pop_back();
    }
    return text + "…";
}

void PlanPainter::paintAxes() {
    const double step = layout_.tickStep, tick = px(8);
    canvas_.width(std::max(1.0, px(1.5)));
    canvas_.letters(px(plan_style::labelLetters));
    canvas_.colour(axis);
    canvas_.frame(layout_.left, layout_.top, layout_.plotWidth, layout_.plotHeight);
    for (const double x : ticksBetween(layout_.low.x, layout_.high.x, step)) {
        const double at = layout_.pixelOf({x, 0}).x;
        canvas_.line({at, bottom()}, {at, bottom() + tick});
        canvas_.text(tickText(x, step), at, bottom() + px(32), Align::Middle);
    }
    for (const double y : ticksBetween(layout_.low.y, layout_.high.y, step)) {
        const double at = layout_.pixelOf({0, y}).y;
        canvas_.line({layout_.left - tick, at}, {layout_.left, at});
        canvas_.text(tickText(y, step), layout_.left - px(14), at + px(7), Align::Right);
    }
    canvas_.colour(ink);
    canvas_.text("x [m] →", layout_.left + 0.5 * layout_.plotWidth, bottom() + px(66),
                 Align::Middle);
    canvas_.textUpwards("y [m] →", px(32), layout_.top + 0.5 * layout_.plotHeight);
}

/// Half filled, half not, its length beside it.
void PlanPainter::paintScale() {
    const double length = layout_.scaleLength * layout_.pixelsPerMetre;
    const std::string text = tickText(layout_.scaleLength, layout_.scaleLength) + " m";
    canvas_.letters(px(plan_style::labelLetters));
    const double end = right() - canvas_.widthOf(text) - px(12), y = bottom() + px(53);
    canvas_.colour(ink);
    canvas_.text(text, right(), y + px(13), Align::Right);
    canvas_.width(std::max(1.0, px(1.5)));
    canvas_.frame(end - length, y, length, px(10));
    canvas_.fill(end - length, y, 0.5 * length, px(10));
}

void PlanPainter::paintLegend() {
    canvas_.letters(px(plan_style::labelLetters));
    for (size_t i = 0; i < figure_.legend.size(); ++i) {
        const PlanLegendEntry& entry = figure_.legend[i];
        const auto [x, y] = layout_.legendAt[i];
        paintMark(entry, x, y);
        canvas_.colour(ink);
        canvas_.text(entry.text, x + px(plan_style::legendMark), y + px(7));
    }
}

void PlanPainter::paintMark(const PlanLegendEntry& entry, double x, double y) {
    using Mark = PlanLegendEntry::Mark;
    const double length = px(plan_style::legendMark - 14);
    canvas_.colour(entry.mark == Mark::Band ? lighter(entry.colour) : entry.colour);
    if (entry.mark == Mark::Dot) return canvas_.disc({x + 0.5 * length, y}, px(6));
    if (entry.mark == Mark::Band) return canvas_.fill(x, y - px(7), length, px(14));
    canvas_.width(px(5));
    if (entry.mark == Mark::DashedLine) canvas_.dashes(px(6), px(9));
    canvas_.line({x + px(2.5), y}, {x + length - px(2.5), y});
    canvas_.solid();
}

}  // namespace offmap::view
