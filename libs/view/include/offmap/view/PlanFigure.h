// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Wall.h>

#include <mrpt/img/TColor.h>
#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <string>
#include <vector>

namespace offmap::view {

/// A wall as a plan shows it. All [px] are those of a figure of 1600; they grow with its size.
struct PlanStroke {
    core::Wall wall;
    mrpt::img::TColor colour;
    double width = 3;     ///< [px]
    double band = 0;      ///< [m] to either side, lighter, under all strokes: a standard deviation
    bool dashed = false;  ///< drawn with gaps
};

struct PlanDot {
    mrpt::math::TPoint2D place;  ///< [m] map frame
    mrpt::img::TColor colour;
    double radius = 3;  ///< [px]
};

struct PlanLegendEntry {
    enum class Mark : uint8_t { Line, DashedLine, Band, Dot };

    std::string text;
    mrpt::img::TColor colour;
    Mark mark = Mark::Line;
};

/// A plan from above on white, x to the right and y upwards, with axes in metres and a scale.
struct PlanFigure {
    std::string title, subtitle;
    std::vector<PlanStroke> strokes;  ///< the last on top
    std::vector<PlanDot> dots;        ///< over all strokes
    std::vector<PlanLegendEntry> legend;
    uint32_t size = 1600;  ///< [px] of the longer side, 200 to 20,000
};

/// The figure as a PNG or SVG file has it. Text must be UTF-8.
/// \throw std::invalid_argument for another size, or what is too large or too far for a picture
std::string pngOf(const PlanFigure& figure);
std::string svgOf(const PlanFigure& figure);

/// Colours that are told apart on white, dark first; they repeat after ten.
mrpt::img::TColor planColour(size_t index);

}  // namespace offmap::view
