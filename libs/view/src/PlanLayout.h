// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/PlanFigure.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace offmap::view {

/// [px] How wide a text is in letters of that size [px].
using TextWidth = std::function<double(const std::string& text, double letters)>;

/// Where everything stands in a plan. All in [px] from the top left corner, if not said otherwise.
struct PlanLayout {
    double unit;  ///< one pixel of a figure of 1600
    double width, height;
    double left, top, plotWidth, plotHeight;  ///< the frame around the plan
    mrpt::math::TPoint2D low, high;           ///< [m] what the frame shows
    double pixelsPerMetre;
    double tickStep;                                  ///< [m]
    double scaleLength;                               ///< [m] of the scale bar
    std::vector<std::pair<double, double>> legendAt;  ///< of each entry, middle of its left end

    mrpt::math::TPoint2D pixelOf(const mrpt::math::TPoint2D& place) const {
        return {left + (place.x - low.x) * pixelsPerMetre,
                top + (high.y - place.y) * pixelsPerMetre};
    }
};

/// Sizes of letters and gaps, in a figure of 1600. [px]
namespace plan_style {
constexpr double titleLetters = 32, subtitleLetters = 21, labelLetters = 20;
constexpr double legendRow = 36, legendMark = 44, legendGap = 36;
}  // namespace plan_style

/// \throw std::invalid_argument as PlanFigure.h says
PlanLayout layoutOf(const PlanFigure& figure, const TextWidth& textWidth);

/// The places of ticks between two values.
std::vector<double> ticksBetween(double low, double high, double step);

/// "-2", "0.25": as many decimals as the step needs.
std::string tickText(double value, double step);

}  // namespace offmap::view
