// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Interval.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/view/Palette.h>
#include <offmap/view/PlacedReturns.h>

#include <cstdint>
#include <span>
#include <vector>

namespace offmap::view {

/// What the colour of a return tells.
enum class ColourBy : uint8_t {
    Label,      ///< what became of it: figures 7 and 8
    Height,     ///< z in the map, from the lowest 2 % to the highest
    Intensity,  ///< how bright it is, up to the brightest but 2 %, as far as that is known
    Residual,   ///< of its segment: blue in front of the wall by 5 standard deviations, red behind
    Reason,     ///< why its segment was kept
};

/// [-] Standard deviations that the colours of residuals reach to.
inline constexpr double colouredResidual = 5;

/// [m] z in the map that the colours of heights reach from and to.
core::Interval colouredHeights(const PlacedReturns& returns);

/// [-] Intensities that the colours reach from and to: those of most returns use little of what a
/// sensor can tell.
core::Interval colouredIntensities(std::span<const float> intensities);

/// A colour for each placed return.
/// \param intensities [0, 1] one per point of the scan, NaN where unknown; may be empty
std::vector<mrpt::img::TColor> coloursOf(const PlacedReturns& returns,
                                         const core::OrganizedScan& scan,
                                         const core::ReductionResult& result, ColourBy colourBy,
                                         const Palette& palette,
                                         std::span<const float> intensities = {});

}  // namespace offmap::view
