// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FigureLegend.h"
#include "PlanCanvas.h"

#include <mrpt/img/CImage.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace offmap::view {

/// A figure in the making: pictures, and text above them. All lengths in [px] from the top left
/// corner; `unit` are those of a figure of 1800 x 900, letters and marks grow with it.
class FigureSheet {
 public:
    FigureSheet(uint32_t width, uint32_t height, const Palette& palette);

    double unit() const { return unit_; }

    /// Title and legend: in one line where they fit, else the legend flows below.
    /// \return the height of it all
    uint32_t heading(const std::string& title, const std::vector<LegendEntry>& legend);

    void paste(const mrpt::img::CImage& picture, uint32_t x, uint32_t y);
    void fill(const mrpt::img::TColor& colour, uint32_t x, uint32_t y, uint32_t width,
              uint32_t height);
    /// A round length that stands for what it says, its lower left corner there.
    void scale(uint32_t left, uint32_t bottom, double pixelsPerMetre);

    /// \throw std::invalid_argument if it could not be drawn: text that is not UTF-8
    mrpt::img::CImage image();

 private:
    double widthOf(const LegendEntry& entry);
    void paint(const LegendEntry& entry, double x, double baseline);
    void paintRow(std::span<const LegendEntry> entries, double x, double baseline);

    uint32_t width_, height_;
    Palette palette_;
    double unit_;
    PlanCanvas canvas_;
};

}  // namespace offmap::view
