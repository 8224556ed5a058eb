// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/MapMatching.h>
#include <offmap/core/ReductionResult.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace offmap::core {

/// Where the segments of each column are, in the list and in the map: what looks at neighbours
/// needs.
class SegmentsByColumn {
 public:
    /// \param segments by column
    /// \param viewpoints one per column; none: the column has no usable pose
    void build(std::span<const VerticalSegment> segments,
               std::span<const std::optional<Viewpoint>> viewpoints);

    /// Half-open range of a column's segments.
    std::pair<uint32_t, uint32_t> of(uint32_t column) const {
        return {first_[column], first_[column + 1]};
    }
    /// [m] map frame; meaningless for a segment whose column has no viewpoint.
    const mrpt::math::TPoint2D& centreInMap(uint32_t segment) const {
        return centreInMap_[segment];
    }

 private:
    std::vector<uint32_t> first_;  // per column, and one more
    std::vector<mrpt::math::TPoint2D> centreInMap_;
};

}  // namespace offmap::core
