// SPDX-License-Identifier: BSD-3-Clause
#include "PlotsPane.h"

#include "AxisTicks.h"
#include "Curves.h"
#include "Lettering.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <wx/pen.h>

namespace offmap::window {

namespace {

constexpr double span = 60;              // [s] shown
constexpr double longestPause = 2;       // [s] between samples that belong together
constexpr size_t mostSamples = 1 << 15;  // 500 turns per second for a minute
// [DIP]
constexpr int axisWidth = 50, rightMargin = 16, headHeight = 18, gapBelow = 5, secondsHeight = 18;

std::string textOf(const Series& series, const char* form) {
    const auto last = series.last();
    return last ? fmt::format(fmt::runtime(form), last->value) : std::string();
}

std::string countOf(const Series& series) {
    const auto last = series.last();
    return last ? rawlog::grouped(static_cast<uint64_t>(std::max(last->value, 0.0))) : "";
}

/// A round value above all of a curve in the last minute.
double topOf(const Series& series, double now, double least) {
    return roundUp(std::max(series.greatest(now - span).value_or(least), least));
}

}  // namespace

PlotsPane::PlotsPane(wxWindow* parent)
    : DrawnPane(parent, {260, 240}),
      removed_(mostSamples),
      milliseconds_(mostSamples),
      latency_(mostSamples),
      kept_(mostSamples) {}

void PlotsPane::add(double seconds, double removedShare, double milliseconds, double latency,
                    double keptPoints) {
    if (!std::isfinite(seconds)) return;
    if (seconds < now_) clear();
    now_ = seconds;
    removed_.add(seconds, 100 * removedShare);
    milliseconds_.add(seconds, milliseconds);
    latency_.add(seconds, latency);
    kept_.add(seconds, keptPoints);
    for (Series* series : {&removed_, &milliseconds_, &latency_, &kept_}) {
        series->forgetBefore(seconds - span);
    }
    Refresh(false);
}

void PlotsPane::clear() {
    for (Series* series : {&removed_, &milliseconds_, &latency_, &kept_}) series->clear();
    now_ = 0;
    Refresh(false);
}

void PlotsPane::draw(wxGraphicsContext& canvas, const wxSize& size) {
    const double below = FromDIP(secondsHeight);
    const double height = std::max((size.y - below) / 3, 1.0);
    const auto place = [&](int row) {
        return wxRect2DDouble(0, std::floor(row * height), size.x, std::floor(height));
    };
    const std::array<Curve, 1> removed{
        {{removed_, "removed", textOf(removed_, "{:.1f} %"), theme().removed}}};
    const std::array<Curve, 2> times{
        {{milliseconds_, "reduce", textOf(milliseconds_, "{:.2f} ms"), theme().timing},
         {latency_, "latency", textOf(latency_, "{:.1f} ms"), theme().accent}}};
    const std::array<Curve, 1> kept{{{kept_, "points kept", countOf(kept_), theme().good}}};
    drawPlot(canvas, place(0), 100, removed);
    drawPlot(canvas, place(1), std::max(topOf(milliseconds_, now_, 1), topOf(latency_, now_, 1)),
             times);
    drawPlot(canvas, place(2), topOf(kept_, now_, 10), kept);
}

void PlotsPane::drawPlot(wxGraphicsContext& canvas, const wxRect2DDouble& place, double top,
                         std::span<const Curve> curves) {
    const double left = FromDIP(axisWidth), head = FromDIP(headHeight);
    const wxRect2DDouble box(left, place.m_y + head,
                             std::max(place.m_width - left - FromDIP(rightMargin), 1.0),
                             std::max(place.m_height - head - FromDIP(gapBelow), 1.0));
    drawHeads(canvas, place, curves);
    drawLevels(canvas, box, top);
    drawSeconds(canvas, box);
    for (const Curve& curve : curves) {
        const auto columns = curve.series.columns(now_ - span, std::nextafter(now_, now_ + 1),
                                                  static_cast<size_t>(box.m_width), longestPause);
        drawCurve(canvas, {box, top}, columns, curve.colour);
    }
}

void PlotsPane::drawHeads(wxGraphicsContext& canvas, const wxRect2DDouble& place,
                          std::span<const Curve> curves) {
    const double y = place.m_y + 0.55 * FromDIP(headHeight);
    double x = FromDIP(axisWidth);
    for (const Curve& curve : curves) {
        const std::string head = curve.name + "  " + curve.now;
        canvas.SetFont(smallFont(*this), curve.colour);
        drawText(canvas, head, x, y);
        x += extentOf(canvas, head).x + FromDIP(16);
    }
}

void PlotsPane::drawLevels(wxGraphicsContext& canvas, const wxRect2DDouble& box, double top) {
    canvas.SetFont(smallFont(*this), theme().subtle);
    canvas.SetPen(wxPen(theme().grid, 1));
    const auto most = static_cast<size_t>(std::clamp(box.m_height / FromDIP(18) + 1, 2.0, 6.0));
    for (const AxisTick& tick : axisTicks(0, top, most)) {
        const double y = std::round(box.GetBottom() - tick.value / top * box.m_height) + 0.5;
        canvas.StrokeLine(box.m_x, y, box.GetRight(), y);
        drawText(canvas, tick.label, box.m_x - FromDIP(6), y, Beside::Left);
    }
}

void PlotsPane::drawSeconds(wxGraphicsContext& canvas, const wxRect2DDouble& box) {
    const bool lowest =
        box.GetBottom() + FromDIP(gapBelow + secondsHeight) + 3 >= GetClientSize().y;
    canvas.SetPen(wxPen(theme().grid, 1));
    for (const AxisTick& tick : axisTicks(-span, 0, 5)) {
        const double x = std::round(box.GetRight() + tick.value / span * box.m_width) - 0.5;
        canvas.StrokeLine(x, box.m_y, x, box.GetBottom());
        const double y = box.GetBottom() + FromDIP(gapBelow) + 0.5 * FromDIP(secondsHeight) - 2;
        if (lowest) drawText(canvas, tick.label + " s", x, y, Beside::Centre);
    }
}

}  // namespace offmap::window
