// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Alignment.h>
#include <offmap/core/Interval.h>
#include <offmap/core/SensorPose.h>

#include <mrpt/math/TPoint2D.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace offmap::core {

/// What became of a return (figures 7 and 8: white, light green, dark red). Orphan: removed on
/// request, 3.4.
enum class PointLabel : uint8_t { NotOnVerticalSegment, Kept, Mapped, Orphan };

/// Whether a reduced scan is without the returns of this label.
constexpr bool isRemoved(PointLabel label) {
    return label == PointLabel::Mapped || label == PointLabel::Orphan;
}

/// What became of a vertical segment.
enum class Verdict : uint8_t {
    MappedByRay,        ///< the ray through it meets a wall at its ground range (section 3.2)
    MappedByExtension,  ///< it continues a horizontal line of matched segments (section 3.3)
    RemovedAsOrphan,    ///< nothing stands beside it (section 3.4); never unless asked for
    Kept,
};

/// Why a segment was kept.
enum class KeepReason : uint8_t {
    None,             ///< it was not kept
    InFrontOfWall,    ///< nearer than the wall
    BehindWall,       ///< further than the wall: the map's wall is not there, or the pose is wrong
    NoWallOnRay,      ///< no wall in this direction
    AmbiguousCorner,  ///< fits only a wall that the heading's uncertainty might turn the ray to
    NoPose,           ///< the column has no pose to be trusted
};
inline constexpr size_t keepReasonCount = 6;

std::string_view toString(Verdict verdict);
std::string_view toString(KeepReason reason);

/// A vertical line segment found in one column.
struct VerticalSegment {
    uint32_t column;      ///< index into OrganizedScan::columns
    uint32_t begin, end;  ///< half-open range into OrganizedScan::points
    mrpt::math::TPoint2D
        bottom;  ///< (ground range, z) [m] of the fitted line's lower end, sensor levelled
    mrpt::math::TPoint2D top;  ///< (ground range, z) [m] of its upper end
    double slope;              ///< [-] ground range per height, without sign
    mrpt::math::TPoint2D
        centre;  ///< [m] mean of its points on the ground, from the sensor, map's axes
    double nearest = 0, furthest = 0;  ///< [m] ground ranges that its points span
    double lowest = 0, highest = 0;    ///< [m] heights that they span, above the sensor

    /// [rad] gamma, against the z axis, [0, pi/2]
    double tilt() const { return std::atan(slope); }
};

/// A segment's match to the map, in full.
struct SegmentMatch {
    Verdict verdict = Verdict::Kept;
    KeepReason reason = KeepReason::NoPose;
    std::optional<uint32_t> wall;  ///< index into LineMap::walls(): matched, or met by the ray
    Interval measured{0, 0};       ///< [m] ground range, eqs. 3 to 5
    std::optional<Interval>
        predicted;  ///< [m] ground range of the map's wall, eq. 7; none without a hit
    /// [-] (measured - predicted ground range) / its standard deviation; negative: in front. 0
    /// without a hit.
    double residual = 0;

    bool mapped() const {
        return verdict == Verdict::MappedByRay || verdict == Verdict::MappedByExtension;
    }
};

/// What a scan was reduced to.
struct ReductionResult {
    std::vector<PointLabel> labels;         ///< one per point of the scan
    std::vector<VerticalSegment> segments;  ///< by column, bottom to top
    std::vector<SegmentMatch> matches;      ///< one per segment
    /// Set if no column could be reduced: all is kept, for this reason.
    std::optional<PoseFault> notReduced;
    uint32_t columnsWithoutPose = 0;  ///< of columns that hold points
    /// How the poses were conditioned on the scan; none with methods that do not.
    std::optional<Alignment> alignment;
};

}  // namespace offmap::core
