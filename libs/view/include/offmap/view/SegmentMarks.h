// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>
#include <offmap/view/Palette.h>

#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <optional>

namespace offmap::view {

/// A vertical segment lit up: its returns, its fitted line and, on the floor, the beam from the
/// sensor to it with the measured interval and, beside that, the predicted one; and the wall that
/// it was compared with. Parts by name: "returns", "line", "beam", "measured", "predicted", "wall";
/// what there is none of is left out. The set is named "segment".
/// \param fallbackSensorInMap as placedReturns() was given it; a segment that stands nowhere gives
/// an empty set
/// \throw std::out_of_range if there is no such segment
mrpt::opengl::CSetOfObjects::Ptr segmentMarksOf(
    const core::OrganizedScan& scan, const core::ReductionResult& result, const core::LineMap& map,
    uint32_t segment, const Palette& palette,
    const std::optional<mrpt::poses::CPose3D>& fallbackSensorInMap = {});

}  // namespace offmap::view
