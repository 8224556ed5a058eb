// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentAtWall.h"

namespace offmap::core {

bool ReturnOffsets::isAt(uint32_t wall, uint32_t point, const CorrectedColumn& column) const {
    const double sigma = sigmaRange(point);
    return isWithinGate(map_, wall, correction_, column, seen(point), sigma * sigma, config_.gate);
}

double ReturnOffsets::commonSigma(const VerticalSegment& segment, uint32_t wall) const {
    return offsetFrom(map_, wall, correction_, corrected(segment.column), middleOf(segment),
                      segment.centre, 0)
        .sigma;
}

}  // namespace offmap::core
