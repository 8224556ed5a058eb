// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PlanCanvas.h"
#include "PlanLayout.h"

#include <string>
#include <vector>

namespace offmap::view {

/// Draws a plan; all three must outlive it.
class PlanPainter {
 public:
    PlanPainter(const PlanFigure& figure, const PlanLayout& layout, PlanCanvas& canvas)
        : figure_(figure), layout_(layout), canvas_(canvas) {}

    void paint();

 private:
    double px(double length) const { return length * layout_.unit; }
    double bottom() const { return layout_.top + layout_.plotHeight; }
    double right() const { return layout_.left + layout_.plotWidth; }

    void paintGrid();
    std::vector<mrpt::math::TPoint2D> pixelsAlong(const core::Wall& wall) const;
    void paintStrokes(bool bands);
    void paintTitle();
    std::string fitting(std::string text);
    void paintAxes();
    void paintScale();
    void paintLegend();
    void paintMark(const PlanLegendEntry& entry, double x, double y);

    const PlanFigure& figure_;
    const PlanLayout& layout_;
    PlanCanvas& canvas_;
};

}  // namespace offmap::view
