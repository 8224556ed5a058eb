// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/view/Scene.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/img/CImage.h>

#include <cstdint>
#include <optional>
#include <string>

namespace offmap::view {

struct FigureOptions {
    uint32_t width = 1800, height = 900;     ///< [px]
    std::string title;                       ///< ASCII
    double azimuth = mrpt::DEG2RAD(-120.0);  ///< [rad] where the perspective is seen from
    double elevation = mrpt::DEG2RAD(32.0);  ///< [rad]
    SceneOptions scene;
    /// Places columns without a pose; none: they are left out.
    std::optional<mrpt::poses::CPose3D> fallbackSensorInMap;
};

/// What became of a scan in one picture, as in figures 7 and 8: from aside and from above, with the
/// map, a legend that counts the returns, and a scale.
mrpt::img::CImage figureOf(const core::OrganizedScan& scan, const core::ReductionResult& result,
                           const core::LineMap& map, const FigureOptions& options = {});

}  // namespace offmap::view
