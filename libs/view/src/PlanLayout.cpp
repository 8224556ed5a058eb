// SPDX-License-Identifier: BSD-3-Clause
#include "PlanLayout.h"

#include <offmap/core/WallGeometry.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace offmap::view {

namespace {

using mrpt::math::TPoint2D;

struct Extent {
    TPoint2D low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    TPoint2D high{-low.x, -low.y};

    void take(const TPoint2D& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
};

void grow(double& low, double& high, double size) {
    const double middle = 0.5 * (low + high);
    low = std::min(low, middle - 0.5 * size);
    high = std::max(high, middle + 0.5 * size);
}

/// All that is drawn, with a margin, neither too slim nor too flat for a page.
Extent extentOf(const PlanFigure& figure) {
    constexpr double margin = 0.05;     // of the longer side
    constexpr double slimmest = 0.45;   // shorter side over longer
    constexpr double coarsest = 1e-12;  // of a coordinate: what doubles tell apart, and some more
    Extent extent;
    for (const PlanStroke& stroke : figure.strokes) {
        const core::WallBounds bounds = core::boundsOf(stroke.wall);
        extent.take(bounds.low);
        extent.take(bounds.high);
    }
    for (const PlanDot& dot : figure.dots) extent.take(dot.place);
    if (figure.strokes.empty() && figure.dots.empty()) extent = {{0, 0}, {1, 1}};
    double size = std::max(extent.width(), extent.height());
    const double farthest = std::max({std::abs(extent.low.x), std::abs(extent.high.x),
                                      std::abs(extent.low.y), std::abs(extent.high.y)});
    if (!std::isfinite(size) || farthest * coarsest > std::max(size, 1e-3)) {
        throw std::invalid_argument(
            "the plan is too large or too far from the origin for a picture");
    }
    size = (1 + 2 * margin) * std::max(size, 1e-3);
    const double wide = extent.width() + margin * size, high = extent.height() + margin * size;
    grow(extent.low.x, extent.high.x, std::max(wide, slimmest * size));
    grow(extent.low.y, extent.high.y, std::max(high, slimmest * size));
    return extent;
}

/// 1, 2 or 5 times a power of ten, at least that much.
double roundedUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value * (1 - 1e-9)) return factor * power;
    }
    return 10 * power;
}

double widestLabel(const Extent& extent, double step, double letters, const TextWidth& textWidth) {
    double widest = 0;
    for (const double tick : ticksBetween(extent.low.y, extent.high.y, step)) {
        widest = std::max(widest, textWidth(tickText(tick, step), letters));
    }
    return widest;
}

/// Puts the legend's entries side by side and below each other. \return its height
double placeLegend(const PlanFigure& figure, const TextWidth& textWidth, PlanLayout& layout) {
    using namespace plan_style;
    layout.legendAt.clear();
    double x = 0, y = 0.5 * legendRow * layout.unit;
    for (const PlanLegendEntry& entry : figure.legend) {
        const double wide = (legendMark + legendGap) * layout.unit +
                            textWidth(entry.text, labelLetters * layout.unit);
        if (x > 0 && x + wide > layout.plotWidth) {
            x = 0;
            y += legendRow * layout.unit;
        }
        layout.legendAt.emplace_back(x, y);
        x += wide;
    }
    return figure.legend.empty() ? 0 : y + 0.5 * legendRow * layout.unit;
}

}  // namespace

std::vector<double> ticksBetween(double low, double high, double step) {
    constexpr double most = 100;
    std::vector<double> ticks;
    const double first = std::ceil(low / step);
    const double count = std::min(most, std::floor(high / step) - first + 1);
    for (double i = 0; i < count; ++i) ticks.push_back((first + i) * step);
    return ticks;
}

std::string tickText(double value, double step) {
    const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step * 1.0001))), 0, 9);
    const bool isZero = std::abs(value) < 1e-3 * step;
    return fmt::format("{}{:.{}f}", value < 0 && !isZero ? "−" : "", isZero ? 0 : std::abs(value),
                       decimals);
}

PlanLayout layoutOf(const PlanFigure& figure, const TextWidth& textWidth) {
    using namespace plan_style;
    if (figure.size < 200 || figure.size > 20'000) {
        throw std::invalid_argument(
            fmt::format("the size of a figure is 200 to 20,000 pixels, not {}", figure.size));
    }
    const Extent extent = extentOf(figure);
    const double size = figure.size;
    PlanLayout layout{};
    const double unit = layout.unit = size / 1600;
    layout.low = extent.low;
    layout.high = extent.high;
    layout.pixelsPerMetre = size / std::max(extent.width(), extent.height());
    const double right = 32 * unit, axisRows = 88 * unit;
    layout.top = (figure.title.empty() && figure.subtitle.empty() ? 32
                  : figure.subtitle.empty()                       ? 76
                                                                  : 108) *
                 unit;
    double legend = 0;
    // Margins and scale depend on each other, little: twice is enough.
    for (int i = 0; i < 2; ++i) {
        layout.tickStep = roundedUp(100 * unit / layout.pixelsPerMetre);
        layout.left =
            70 * unit + widestLabel(extent, layout.tickStep, labelLetters * unit, textWidth);
        layout.pixelsPerMetre = std::min((size - layout.left - right) / extent.width(),
                                         (size - layout.top - axisRows - legend) / extent.height());
        layout.plotWidth = extent.width() * layout.pixelsPerMetre;
        legend = placeLegend(figure, textWidth, layout);
    }
    layout.pixelsPerMetre =
        std::min(layout.pixelsPerMetre, (size - layout.top - axisRows - legend) / extent.height());
    if (!(layout.pixelsPerMetre > 0)) {
        throw std::invalid_argument("the legend leaves no place for the plan");
    }
    layout.plotWidth = extent.width() * layout.pixelsPerMetre;
    layout.plotHeight = extent.height() * layout.pixelsPerMetre;
    legend = placeLegend(figure, textWidth, layout);
    for (auto& [x, y] : layout.legendAt) {
        x += layout.left;
        y += layout.top + layout.plotHeight + axisRows - 6 * unit;
    }
    layout.width = std::ceil(layout.left + layout.plotWidth + right);
    layout.height = std::ceil(layout.top + layout.plotHeight + axisRows + legend);
    layout.scaleLength = roundedUp(90 * unit / layout.pixelsPerMetre);
    return layout;
}

}  // namespace offmap::view
