// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Colouring.h>
#include <offmap/view/Scene.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/img/CImage.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace offmap::view {

/// Where a figure is seen from.
enum class FigureView : uint8_t {
    Both,  ///< from aside, and from above beside it
    Perspective,
    Top,
};

struct FigureOptions {
    uint32_t width = 1800, height = 900;     ///< [px]
    std::string title;                       ///< UTF-8
    FigureView view = FigureView::Both;      ///< which pictures there are
    double azimuth = mrpt::DEG2RAD(-120.0);  ///< [rad] where the perspective is seen from
    double elevation = mrpt::DEG2RAD(32.0);  ///< [rad]
    ColourBy colourBy = ColourBy::Label;     ///< what the colours of returns tell
    std::vector<float> intensities;          ///< as coloursOf() takes them
    SceneOptions scene;
    /// Places columns without a pose; none: they are left out.
    std::optional<mrpt::poses::CPose3D> fallbackSensorInMap;
};

/// What became of a scan in one picture, as in figures 7 and 8: from aside and from above, with the
/// map, the pose that was given and the refined one, a legend that counts the returns, and a scale.
/// \throw std::invalid_argument if its text fills more than half of it, or it is not UTF-8
mrpt::img::CImage figureOf(const core::OrganizedScan& scan, const core::ReductionResult& result,
                           const core::LineMap& map, const FigureOptions& options = {});

}  // namespace offmap::view
