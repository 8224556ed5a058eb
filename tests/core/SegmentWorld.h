// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ColumnRing.h>
#include <offmap/core/SegmentsByColumn.h>

#include <mrpt/math/TPoint2D.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace offmap::test {

/// Vertical segments seen from the origin, set down column by column: what the steps after the
/// matching work on.
class SegmentWorld {
 public:
    explicit SegmentWorld(uint32_t columns, double sigmaHeading = 0) {
        scan.columns.resize(columns);
        for (uint32_t c = 0; c < columns; ++c) {
            scan.columns[c].azimuth = static_cast<float>(azimuthOf(c));
        }
        viewpoints.assign(columns, core::Viewpoint{{0, 0}, 1, {}, sigmaHeading});
    }

    double azimuthOf(uint32_t column) const {
        return -std::numbers::pi + 2 * std::numbers::pi * column / double(scan.columns.size());
    }
    mrpt::math::TPoint2D directionOf(uint32_t column) const {
        return {std::cos(azimuthOf(column)), std::sin(azimuthOf(column))};
    }

    /// A segment in a column, the columns in ascending order. \return its index
    uint32_t add(uint32_t column, double range, core::Verdict verdict, uint32_t wall = 0) {
        core::VerticalSegment segment{};
        segment.column = column;
        segment.centre = directionOf(column) * range;
        segment.bottom = {range, -1};
        segment.top = {range, 1};
        segments.push_back(segment);
        core::SegmentMatch match;
        match.verdict = verdict;
        match.reason =
            verdict == core::Verdict::Kept ? core::KeepReason::BehindWall : core::KeepReason::None;
        if (verdict == core::Verdict::MappedByRay) match.wall = wall;
        matches.push_back(match);
        return static_cast<uint32_t>(segments.size() - 1);
    }

    /// The range of the line y = offset in a column.
    double rangeToLine(uint32_t column, double offset) const {
        return offset / directionOf(column).y;
    }

    core::OrganizedScan scan;
    std::vector<std::optional<core::Viewpoint>> viewpoints;
    std::vector<core::VerticalSegment> segments;
    std::vector<core::SegmentMatch> matches;
};

}  // namespace offmap::test
