// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentAtWall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace offmap::core {

using mrpt::math::TPoint2D;

namespace {

constexpr uint32_t reach = 3;  // columns to either side that a removed wall is looked for in

/// [m] Within it, the foot of a wall cannot be told from the floor, nor its top from the ceiling.
constexpr double edge = 0.08;

void extend(RemovedWall& wall, const RemovedWall& more) {
    wall.low = std::min(wall.low, more.low);
    wall.high = std::max(wall.high, more.high);
}

/// Those of neighbouring columns mostly are of one wall.
void join(std::vector<RemovedWall>& walls, std::span<const RemovedWall> more) {
    for (size_t i = 0; i < more.size();) {
        RemovedWall wall = more[i];
        while (++i < more.size() && more[i].wall == wall.wall) extend(wall, more[i]);
        const auto known = std::ranges::find(walls, wall.wall, &RemovedWall::wall);
        if (known == walls.end()) {
            walls.push_back(wall);
        } else {
            extend(*known, wall);
        }
    }
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
    const auto joinColumns = [&](uint32_t begin, uint32_t end) {
        const uint32_t first = scratch.first[begin];
        join(scratch.near, std::span(scratch.removed).subspan(first, scratch.first[end] - first));
    };
    const uint32_t begin = std::max(column, reach) - reach, end = column + reach + 1;
    if (column < reach) joinColumns(columns + column - reach, columns);
    joinColumns(begin, std::min(end, columns));
    if (end > columns) joinColumns(0, end - columns);
}

/// The returns of one column at the walls near it.
class ColumnAtWalls {
 public:
    /// \param sigma [m], [rad] standard deviations of the pose correction
    ColumnAtWalls(const ReturnOffsets& offsets, uint32_t column, const Vector5& sigma,
                  LooseReturnsScratch& scratch)
        : offsets_(offsets), column_(offsets.corrected(column)), scratch_(scratch) {
        const auto& mean = offsets.correction().mean;
        const double lever = (offsets.place(column).position - offsets.correction().pivot).norm();
        openAtSensor_ = sigma[0] + sigma[1] + sigma[2] * lever;
        openPerRange_ = sigma[2];
        openPerHeight_ = sigma[2] * (std::abs(mean[3]) + std::abs(mean[4])) + sigma[3] + sigma[4];
        scratch.behind.clear();
        for (const RemovedWall& removed : scratch.near) {
            lowest_ = std::min(lowest_, removed.low + edge);
            highest_ = std::max(highest_, removed.high - edge);
            const Wall& wall = offsets.wall(removed.wall);
            const TPoint2D along = wall.line.point2 - wall.line.point1;
            scratch.behind.push_back(
                column_.distanceBehind(wall.line.point1, TPoint2D(-along.y, along.x)));
        }
    }

    bool isOnAny(uint32_t point) const {
        const double z = offsets_.z(point);
        if (z < lowest_ || z > highest_) return false;  // mostly floor
        for (size_t i = 0; i < scratch_.near.size(); ++i) {
            const RemovedWall& removed = scratch_.near[i];
            if (z < removed.low + edge || z > removed.high - edge) continue;
            if (isFarFrom(i, point)) continue;
            if (offsets_.isAt(removed.wall, point, column_)) return true;
        }
        return false;
    }

 private:
    /// Whether a return is further from a straight wall than any gate lets it be: sigmas that are
    /// added up are more than their root of squares. Told times the wall's length.
    bool isFarFrom(size_t near, uint32_t point) const {
        const Wall& wall = offsets_.wall(scratch_.near[near].wall);
        const double open = openAtSensor_ + openPerRange_ * offsets_.groundRange(point) +
                            openPerHeight_ * std::abs(offsets_.z(point));
        const double limit =
            offsets_.config().gate * (wall.sigma + offsets_.sigmaRange(point) + open);
        const double behind = scratch_.behind[near].of(offsets_.seen(point));
        const double squaredLength = (wall.line.point2 - wall.line.point1).sqrNorm();
        return wall.curvature == 0 && behind * behind > limit * limit * squaredLength;
    }

    const ReturnOffsets& offsets_;
    CorrectedColumn column_;
    LooseReturnsScratch& scratch_;
    double lowest_ = std::numeric_limits<double>::infinity();  // [m] of all of the walls
    double highest_ = -lowest_;
    double openAtSensor_;   // [m] bound of what the poses leave open across any wall
    double openPerRange_;   // [-] and more per ground range
    double openPerHeight_;  // [-] and per height
};

/// Those of a column, which are the first of those that are left.
std::span<const VerticalSegment> segmentsOf(uint32_t column,
                                            std::span<const VerticalSegment> left) {
    const auto end = std::ranges::find_if(
        left, [&](const VerticalSegment& segment) { return segment.column != column; });
    return {left.begin(), end};
}

/// Calls use(point) for what lies on no segment of a column.
template <class Use>
void forEachBeside(std::span<const VerticalSegment> segments, const ScanColumn& column,
                   const Use& use) {
    uint32_t i = column.begin;
    for (const VerticalSegment& segment : segments) {
        for (; i < segment.begin; ++i) use(i);
        i = segment.end;
    }
    for (; i < column.end; ++i) use(i);
}

}  // namespace

void labelLooseReturns(const ReturnOffsets& offsets, std::span<const VerticalSegment> segments,
                       std::span<const SegmentMatch> matches, LooseReturnsScratch& scratch,
                       std::span<PointLabel> labels) {
    const auto& columns = offsets.scan().columns;
    findRemoved(columns.size(), segments, matches, scratch);
    const Vector5 sigma = offsets.correction().covariance.diagonal().cwiseSqrt();
    for (uint32_t c = 0; c < columns.size(); ++c) {
        const auto own = segmentsOf(c, segments);
        segments = segments.subspan(own.size());
        if (!columns[c].sensor || columns[c].begin == columns[c].end) continue;
        findNear(c, scratch);
        if (scratch.near.empty()) continue;
        const ColumnAtWalls walls(offsets, c, sigma, scratch);
        forEachBeside(own, columns[c], [&](uint32_t i) {
            const bool isLoose = labels[i] == PointLabel::NotOnVerticalSegment;
            if (isLoose && walls.isOnAny(i)) labels[i] = PointLabel::Mapped;
        });
    }
}

}  // namespace offmap::core
