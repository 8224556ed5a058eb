// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentAtWall.h"

#include <algorithm>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr uint32_t reach = 3;  // columns to either side that a removed wall is looked for in

/// [m] Within it, the foot of a wall cannot be told from the floor, nor its top from the ceiling.
constexpr double edge = 0.08;

/// A wall that segments of a column were removed with, and between which heights.
struct RemovedWall {
    uint32_t wall;
    double low, high;  // [m] above the sensor
};

void join(std::vector<RemovedWall>& walls, const RemovedWall& more) {
    const auto known = std::ranges::find(walls, more.wall, &RemovedWall::wall);
    if (known == walls.end()) {
        walls.push_back(more);
        return;
    }
    known->low = std::min(known->low, more.low);
    known->high = std::max(known->high, more.high);
}

/// The removed walls of each column, and of those near it.
class RemovedWalls {
 public:
    RemovedWalls(size_t columns, std::span<const VerticalSegment> segments,
                 std::span<const SegmentMatch> matches)
        : ofColumn_(columns) {
        forEachRemoved(segments, matches, [&](const VerticalSegment& segment, uint32_t wall) {
            ofColumn_[segment.column].push_back({wall, segment.bottom.y, segment.top.y});
        });
    }

    /// Fills `walls` with those of the columns from `reach` before to `reach` behind, round the
    /// turn's end.
    void near(uint32_t column, std::vector<RemovedWall>& walls) const {
        walls.clear();
        const auto columns = static_cast<uint32_t>(ofColumn_.size());
        if (columns <= 2 * reach) return;
        for (uint32_t step = 0; step <= 2 * reach; ++step) {
            const uint32_t c = (column + columns - reach + step) % columns;
            for (const RemovedWall& wall : ofColumn_[c]) join(walls, wall);
        }
    }

 private:
    std::vector<std::vector<RemovedWall>> ofColumn_;
};

bool liesOn(const RemovedWall& wall, uint32_t point, uint32_t column,
            const ReturnOffsets& offsets) {
    const double z = offsets.seen(point).z;
    if (z < wall.low + edge || z > wall.high - edge) return false;
    const WallOffset offset = offsets.of(point, column, wall.wall);
    return offset.distance <= offsets.config().gate * offset.sigma;
}

}  // namespace

void labelLooseReturns(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                       std::span<const SegmentMatch> matches, std::span<PointLabel> labels) {
    const auto& columns = offsets.scan().columns;
    const RemovedWalls removed(columns.size(), segments, matches);
    std::vector<RemovedWall> walls;
    for (uint32_t c = 0; c < columns.size(); ++c) {
        if (!columns[c].sensor || columns[c].begin == columns[c].end) continue;
        removed.near(c, walls);
        if (walls.empty()) continue;
        for (uint32_t i = columns[c].begin; i < columns[c].end; ++i) {
            if (labels[i] != PointLabel::NotOnVerticalSegment) continue;
            const bool mapped = std::ranges::any_of(
                walls, [&](const RemovedWall& wall) { return liesOn(wall, i, c, offsets); });
            if (mapped) labels[i] = PointLabel::Mapped;
        }
    }
}

}  // namespace offmap::core
