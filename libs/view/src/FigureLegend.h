// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Figure.h>

#include <mrpt/img/TColor.h>

#include <string>
#include <vector>

namespace offmap::view {

struct LegendEntry {
    enum class Mark : uint8_t { Square, Line, Scale };

    std::string text;  ///< right of the mark
    mrpt::img::TColor colour{};
    Mark mark = Mark::Square;
    std::string before{};                           ///< left of a scale
    mrpt::img::TColor (*colourAt)(double share){};  ///< [0, 1] of a scale, from left to right
};

/// What the colours of a figure mean, and how many returns have them.
std::vector<LegendEntry> legendOf(const PlacedReturns& returns, const core::OrganizedScan& scan,
                                  const core::ReductionResult& result,
                                  const FigureOptions& options);

}  // namespace offmap::view
