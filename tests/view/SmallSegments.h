// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SmallScan.h"

namespace offmap::view {

/// The small scan with its first two poles as segments: the first mapped by ray, 0.1 m behind where
/// the map has wall 0; the second 0.5 m in front of it and 5 standard deviations.
struct SmallSegments : SmallScan {
    SmallSegments() {
        for (const uint32_t pole : {0U, 1U}) {
            core::VerticalSegment segment{};
            segment.column = pole;
            segment.begin = 11 * pole;
            segment.end = 11 * (pole + 1);
            segment.bottom = {4, -1};
            segment.top = {4, 1};
            segment.centre = {pole == 0 ? -4.0 : 4.0, 0};
            result.segments.push_back(segment);
            scan.columns[pole].azimuth = mrpt::DEG2RAD(pole == 0 ? 90.0F : -90.0F);
        }
        core::SegmentMatch mapped, inFront;
        mapped.verdict = core::Verdict::MappedByRay;
        mapped.reason = core::KeepReason::None;
        mapped.wall = 0;
        mapped.measured = {3.95, 4.05};
        mapped.predicted = core::Interval(3.78, 4.02);
        mapped.residual = 2.5;
        inFront.reason = core::KeepReason::InFrontOfWall;
        inFront.wall = 0;
        inFront.measured = {3.95, 4.05};
        inFront.predicted = core::Interval(4.2, 4.8);
        inFront.residual = -5;
        result.matches = {mapped, inFront};
    }
};

}  // namespace offmap::view
