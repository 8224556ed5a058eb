// SPDX-License-Identifier: BSD-3-Clause
#include "LineSpecks.h"

#include "Groups.h"

#include <offmap/core/WallGeometry.h>

#include <algorithm>
#include <cmath>

namespace offmap::maps {

using mrpt::math::TPoint2D;

namespace {

/// An end of a wall in a square of a grid.
struct GriddedEnd {
    int64_t row, column;
    TPoint2D place;
    uint32_t wall;
};

/// Finds ends by their place.
class Ends {
 public:
    explicit Ends(std::span<const core::Wall> walls) {
        for (uint32_t i = 0; i < walls.size(); ++i) {
            for (const TPoint2D& end : {walls[i].line.point1, walls[i].line.point2}) {
                ends_.push_back({cell(end.y), cell(end.x), end, i});
            }
        }
        std::ranges::sort(ends_, isBefore);
    }

    template <class Tell>
    void near(const TPoint2D& place, const Tell& tell) const {
        const int64_t row = cell(place.y), column = cell(place.x);
        for (int64_t r = row - 1; r <= row + 1; ++r) {
            const GriddedEnd first{r, column - 1, {}, 0};
            for (auto end = std::ranges::lower_bound(ends_, first, isBefore);
                 end != ends_.end() && end->row == r && end->column <= column + 1; ++end) {
                if ((end->place - place).norm() <= reach) tell(end->wall);
            }
        }
    }

 private:
    static bool isBefore(const GriddedEnd& one, const GriddedEnd& other) {
        return std::pair(one.row, one.column) < std::pair(other.row, other.column);
    }
    static int64_t cell(double coordinate) {
        constexpr double last = 9e15;  // that the next one is another number
        return static_cast<int64_t>(std::floor(std::clamp(coordinate / reach, -last, last)));
    }

    static constexpr double reach = 0.001;  // [m] also the side of a square
    std::vector<GriddedEnd> ends_;
};

void extend(core::WallBounds& bounds, const core::WallBounds& by) {
    bounds.low = {std::min(bounds.low.x, by.low.x), std::min(bounds.low.y, by.low.y)};
    bounds.high = {std::max(bounds.high.x, by.high.x), std::max(bounds.high.y, by.high.y)};
}

}  // namespace

std::vector<bool> specksAmong(std::span<const core::Wall> walls, double minLength) {
    std::vector<bool> isShort(walls.size());
    for (size_t i = 0; i < walls.size(); ++i) isShort[i] = core::lengthOf(walls[i]) < minLength;
    if (std::ranges::find(isShort, true) == isShort.end()) return isShort;

    const Ends ends(walls);
    Groups groups(walls.size());
    std::vector<bool> joinsLong(walls.size(), false);
    for (uint32_t i = 0; i < walls.size(); ++i) {
        if (!isShort[i]) continue;
        for (const TPoint2D& end : {walls[i].line.point1, walls[i].line.point2}) {
            ends.near(end, [&](uint32_t other) {
                isShort[other] ? groups.unite(i, other) : void(joinsLong[i] = true);
            });
        }
    }

    std::vector<core::WallBounds> reach(walls.size());
    std::vector<bool> isPart(walls.size(), false);
    for (uint32_t i = 0; i < walls.size(); ++i) reach[i] = core::boundsOf(walls[i]);
    for (uint32_t i = 0; i < walls.size(); ++i) {
        if (isShort[i]) extend(reach[groups.of(i)], reach[i]);
        if (isShort[i] && joinsLong[i]) isPart[groups.of(i)] = true;
    }
    for (uint32_t i = 0; i < walls.size(); ++i) {
        if (!isShort[i]) continue;
        const uint32_t group = groups.of(i);
        const TPoint2D diagonal = reach[group].high - reach[group].low;
        isShort[i] = !isPart[group] && diagonal.norm() < minLength;
    }
    return isShort;
}

}  // namespace offmap::maps
