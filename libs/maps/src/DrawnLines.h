// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DxfContent.h"

#include <offmap/core/Interval.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <limits>
#include <map>
#include <ogr_spatialref.h>
#include <optional>
#include <string>
#include <vector>

namespace offmap::maps {

/// The lines of a file, in its own coordinates, and what of it are none.
struct DrawnLines {
    struct Line {
        size_t begin = 0, end = 0;      ///< of its places, index into points
        uint32_t layer = 0;             ///< index into layers
        int64_t feature = 0;            ///< its number in the file
        bool rises = false;             ///< it is not level, so it may have no length from above
        std::optional<double> sigma{};  ///< [m] if the file states it
        core::Interval height = core::Interval::everything();  ///< [m] z, if the file states it
    };

    std::vector<mrpt::math::TPoint2D> points;
    std::vector<Line> lines;
    std::vector<std::string> layers;
    std::optional<OGRSpatialReference> system;  ///< of the coordinates; none: not known
    std::optional<DrawnUnit> unit;              ///< that the file states
    std::map<std::string, size_t> leftOut;      ///< by what they are, "hatches"; how many
    bool hasHeights = false;                    ///< some of its places have a height
    std::vector<std::string> warnings;
};

}  // namespace offmap::maps
