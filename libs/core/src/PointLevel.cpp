// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentAtWall.h"

namespace offmap::core {

using mrpt::math::TPoint2D;

WallOffset ReturnOffsets::of(uint32_t point, const CorrectedColumn& column, uint32_t wall) const {
    const TPoint2D ground = levelled_.ground(point);
    const double range = groundRange(point);
    const TPoint2D beam = range > 0 ? ground * (1 / range) : TPoint2D(1, 0);
    const double sigma = sigmaRange(point);
    return offsetFrom(map_.walls()[wall], correction_, column, seen(point), beam, sigma * sigma);
}

double ReturnOffsets::commonSigma(const VerticalSegment& segment, uint32_t wall) const {
    return offsetFrom(map_.walls()[wall], correction_, corrected(segment.column), middleOf(segment),
                      segment.centre, 0)
        .sigma;
}

}  // namespace offmap::core
