// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>

#include <mrpt/img/TColor.h>
#include <mrpt/math/TBoundingBox.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace offmap::view {

/// The returns of a scan where they stand in the map, each with what became of it.
struct PlacedReturns {
    std::vector<mrpt::math::TPoint3Df> points;     ///< [m] map frame
    std::vector<core::PointLabel> labels;          ///< one per point
    std::vector<uint32_t> indices;                 ///< of each, into OrganizedScan::points
    std::vector<mrpt::img::TColor> colours;        ///< one per point; empty: by label
    std::vector<mrpt::poses::CPose3D> sensorPath;  ///< where the columns were taken from
};

/// \param fallbackSensorInMap places columns without a pose of their own; none: they are left out
/// \throw std::invalid_argument unless there is one label per point of the scan
PlacedReturns placedReturns(const core::OrganizedScan& scan,
                            std::span<const core::PointLabel> labels,
                            const std::optional<mrpt::poses::CPose3D>& fallbackSensorInMap = {});

/// The part of the map worth looking at: the box around all returns but the outermost 5 % to each
/// side, and around the mapped ones but their outermost 1 %. At least 2 m wide, deep and high.
mrpt::math::TBoundingBox extentOf(const PlacedReturns& returns);

}  // namespace offmap::view
