// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LevelledScan.h>
#include <offmap/core/OrganizedScan.h>
#include <offmap/core/PoseCorrection.h>
#include <offmap/core/ReductionResult.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace offmap::core {

/// A vertical segment as a measurement of where a wall stands. Two points of the line through its
/// returns carry all that these tell of the wall's distance and of the sensor's lean. The line
/// leaves the column's plane if the sensor leans sideways.
struct WallSight {
    uint32_t segment;  ///< index among the segments
    ColumnPlace place;
    SeenPoint lower, upper;     ///< one standard deviation of its returns' heights from the middle
    mrpt::math::TPoint2D beam;  ///< unit vector from the sensor on the ground, map axes
    double heightInMap;         ///< [m] z of the middle
    uint32_t returns;
    std::optional<double> rangeSigma{};  ///< [m] of a single return's range, in the quadratic mean;
                                         ///< none: AlignmentConfig::sigmaRange

    SeenPoint middle() const {
        return {(lower.ground + upper.ground) * 0.5, 0.5 * (lower.z + upper.z)};
    }
};

/// Appends the sight of a segment, unless it stands at the sensor.
/// \param place of its column, which has a pose
void appendSight(uint32_t index, const VerticalSegment& segment, const OrganizedScan& scan,
                 const LevelledScan& levelled, const ColumnPlace& place,
                 std::vector<WallSight>& sights);

/// The sights of all segments whose column has a pose, in the order of the segments.
/// \param places of the scan's columns
void findSights(const OrganizedScan& scan, const LevelledScan& levelled,
                std::span<const ColumnPlace> places, std::span<const VerticalSegment> segments,
                std::vector<WallSight>& sights);

}  // namespace offmap::core
