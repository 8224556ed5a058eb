// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/ReductionResult.h>

#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace offmap::view {

/// What became of one return, and of the vertical segment that it lies on.
struct SegmentStory {
    uint32_t point = 0;                         ///< index into OrganizedScan::points
    uint32_t column = 0;                        ///< index into OrganizedScan::columns
    double azimuth = 0;                         ///< [rad] of it, CCW from the vehicle's x axis
    double range = 0;                           ///< [m] of the return
    std::optional<mrpt::math::TPoint3D> inMap;  ///< [m] its place; none without a pose
    core::PointLabel label{};                   ///< what became of it
    std::optional<core::PoseFault> fault;       ///< why the pose of its column could not be used
    std::optional<uint32_t> segment;            ///< index into ReductionResult::segments
    core::Interval heights{0, 0};               ///< [m] z of the segment, or of the return: in the
                                                ///< map or, without a pose, above the vehicle
    std::optional<core::Interval> measured;     ///< [m] ground range of the segment
    std::optional<core::Interval> predicted;    ///< [m] of the map's wall; none without a hit
    double residual = 0;                        ///< [-] standard deviations; negative: in front
    std::optional<uint32_t> wall;               ///< index into LineMap::walls()
    core::Verdict verdict = core::Verdict::Kept;       ///< on the segment
    core::KeepReason reason = core::KeepReason::None;  ///< why the segment was kept
    uint32_t returns = 0;                              ///< of the segment
    uint32_t removed = 0;                              ///< of these
};

/// The segment that a point of the scan lies on, if it lies on one.
std::optional<uint32_t> segmentOf(const core::ReductionResult& result, uint32_t point);

/// \throw std::out_of_range if the scan has no such point, or the result is that of another scan
SegmentStory storyOf(const core::OrganizedScan& scan, const core::ReductionResult& result,
                     uint32_t point);

/// The story as labels and values for a person to read, with units: "measured", "2.310 ... 2.360
/// m". The last is "why": one sentence that explains what became of the return.
/// \param map that the scan was reduced by
std::vector<std::pair<std::string, std::string>> linesOf(const SegmentStory& story,
                                                         const core::LineMap& map);

}  // namespace offmap::view
