// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentAtWall.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr uint32_t reach = 3;  // columns to either side that a removed wall is looked for in

/// [m] Within it, the foot of a wall cannot be told from the floor, nor its top from the ceiling.
constexpr double edge = 0.08;

void join(std::vector<RemovedWall>& walls, const RemovedWall& more) {
    const auto known = std::ranges::find(walls, more.wall, &RemovedWall::wall);
    if (known == walls.end()) {
        walls.push_back(more);
        return;
    }
    known->low = std::min(known->low, more.low);
    known->high = std::max(known->high, more.high);
}

/// The removed walls of each column.
void findRemoved(size_t columns, std::span<const VerticalSegment> segments,
                 std::span<const SegmentMatch> matches, LooseReturnsScratch& scratch) {
    scratch.first.assign(columns + 1, 0);
    scratch.removed.clear();
    forEachRemoved(segments, matches, [&](const VerticalSegment& segment, uint32_t wall) {
        ++scratch.first[segment.column + 1];
        scratch.removed.push_back({wall, segment.bottom.y, segment.top.y});
    });
    std::partial_sum(scratch.first.begin(), scratch.first.end(), scratch.first.begin());
}

/// Those of the columns from `reach` before to `reach` behind, round the turn's end.
void findNear(uint32_t column, LooseReturnsScratch& scratch) {
    scratch.near.clear();
    const auto columns = static_cast<uint32_t>(scratch.first.size() - 1);
    if (columns <= 2 * reach) return;
    for (uint32_t step = 0; step <= 2 * reach; ++step) {
        const uint32_t c = (column + columns - reach + step) % columns;
        for (uint32_t i = scratch.first[c]; i < scratch.first[c + 1]; ++i) {
            join(scratch.near, scratch.removed[i]);
        }
    }
}

/// The returns of one column at the walls near it.
class ColumnAtWalls {
 public:
    ColumnAtWalls(const ReturnOffsets& offsets, uint32_t column, LooseReturnsScratch& scratch)
        : offsets_(offsets), column_(offsets.corrected(column)), scratch_(scratch) {
        const auto sigma = offsets.correction().covariance.diagonal().array().sqrt().eval();
        const auto& mean = offsets.correction().mean;
        const double lever = (offsets.place(column).position - offsets.correction().pivot).norm();
        openAtSensor_ = sigma[0] + sigma[1] + sigma[2] * lever;
        openPerRange_ = sigma[2];
        openPerHeight_ = sigma[2] * (std::abs(mean[3]) + std::abs(mean[4])) + sigma[3] + sigma[4];
        scratch.behind.clear();
        for (const RemovedWall& removed : scratch.near) {
            const Wall& wall = offsets.wall(removed.wall);
            const TPoint2D along = wall.line.point2 - wall.line.point1;
            scratch.behind.push_back(column_.distanceBehind(
                wall.line.point1, TPoint2D(-along.y, along.x) * (1 / along.norm())));
        }
    }

    bool isOnAny(uint32_t point) const {
        for (size_t i = 0; i < scratch_.near.size(); ++i) {
            const RemovedWall& removed = scratch_.near[i];
            const double z = offsets_.z(point);
            if (z < removed.low + edge || z > removed.high - edge) continue;
            if (isFarFrom(i, point)) continue;
            const WallOffset offset = offsets_.of(point, column_, removed.wall);
            if (offset.distance <= offsets_.config().gate * offset.sigma) return true;
        }
        return false;
    }

 private:
    /// Whether a return is further from a straight wall than any gate lets it be: sigmas that are
    /// added up are more than their root of squares.
    bool isFarFrom(size_t near, uint32_t point) const {
        const Wall& wall = offsets_.wall(scratch_.near[near].wall);
        const double open = openAtSensor_ + openPerRange_ * offsets_.groundRange(point) +
                            openPerHeight_ * std::abs(offsets_.z(point));
        const double sigma = wall.sigma + offsets_.sigmaRange(point) + open;
        return wall.curvature == 0 && std::abs(scratch_.behind[near].of(offsets_.seen(point))) >
                                          offsets_.config().gate * sigma;
    }

    const ReturnOffsets& offsets_;
    CorrectedColumn column_;
    LooseReturnsScratch& scratch_;
    double openAtSensor_;   // [m] bound of what the poses leave open across any wall
    double openPerRange_;   // [-] and more per ground range
    double openPerHeight_;  // [-] and per height
};

}  // namespace

void labelLooseReturns(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                       std::span<const SegmentMatch> matches, LooseReturnsScratch& scratch,
                       std::span<PointLabel> labels) {
    const auto& columns = offsets.scan().columns;
    findRemoved(columns.size(), segments, matches, scratch);
    for (uint32_t c = 0; c < columns.size(); ++c) {
        if (!columns[c].sensor || columns[c].begin == columns[c].end) continue;
        findNear(c, scratch);
        if (scratch.near.empty()) continue;
        const ColumnAtWalls walls(offsets, c, scratch);
        for (uint32_t i = columns[c].begin; i < columns[c].end; ++i) {
            if (labels[i] != PointLabel::NotOnVerticalSegment) continue;
            if (walls.isOnAny(i)) labels[i] = PointLabel::Mapped;
        }
    }
}

}  // namespace offmap::core
