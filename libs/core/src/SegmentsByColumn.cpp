// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/SegmentsByColumn.h>

namespace offmap::core {

void SegmentsByColumn::build(std::span<const VerticalSegment> segments,
                             std::span<const std::optional<Viewpoint>> viewpoints) {
    first_.assign(viewpoints.size() + 1, 0);
    centreInMap_.clear();
    for (const VerticalSegment& segment : segments) {
        ++first_[segment.column + 1];
        const auto& viewpoint = viewpoints[segment.column];
        centreInMap_.push_back(viewpoint ? viewpoint->position + segment.centre
                                         : mrpt::math::TPoint2D());
    }
    for (size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
}

}  // namespace offmap::core
