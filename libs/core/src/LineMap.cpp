// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>
#include <offmap/core/WallGeometry.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace offmap::core {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using mrpt::math::TPoint2D;

using Point = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Entry = std::pair<Box, uint32_t>;

struct LineMap::Index {
    explicit Index(const std::vector<Entry>& entries) : tree(entries) {}
    bgi::rtree<Entry, bgi::quadratic<16>> tree;

    /// Calls visit(wall index) for every wall whose bounding box meets a shape.
    template <class Shape, class Visit>
    void forEachNear(const Shape& shape, Visit&& visit) const {
        tree.query(bgi::intersects(shape),
                   boost::make_function_output_iterator(
                       [&visit](const Entry& entry) { visit(entry.second); }));
    }
};

namespace {

Box boxAround(const TPoint2D& low, const TPoint2D& high, double margin) {
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
}

void requireUsable(const Wall& wall, size_t index) {
    const auto& [a, b] = std::pair(wall.line.point1, wall.line.point2);
    const auto fail = [index](const char* what) {
        throw std::invalid_argument("wall " + std::to_string(index) + " " + what);
    };
    for (const double coordinate : {a.x, a.y, b.x, b.y}) {
        if (!std::isfinite(coordinate)) fail("has an end point that is not finite");
    }
    if (!(wall.sigma >= 0) || !std::isfinite(wall.sigma)) fail("has a sigma that is not >= 0");
    if (a == b) fail("has no length");
    constexpr double rounding = 1e-9;
    const bool bendsByArc =
        std::abs(wall.curvature) * wall.line.length() <= 2 * (1 + rounding);  // not if NaN
    if (!bendsByArc) fail("bends by more than half a circle");
}

}  // namespace

LineMap::LineMap(std::vector<Wall> walls) : walls_(std::move(walls)) {
    std::vector<Entry> entries;
    entries.reserve(walls_.size());
    leftNormals_.reserve(walls_.size());
    for (size_t i = 0; i < walls_.size(); ++i) {
        requireUsable(walls_[i], i);
        leftNormals_.push_back(core::normalAwayFrom({0, 0}, walls_[i], walls_[i].line.point1));
        largestSigma_ = std::max(largestSigma_, walls_[i].sigma);
        // [m] more than what rounding takes from the look-up, even in coordinates of 1e7 m.
        constexpr double margin = 1e-6;
        const auto [low, high] = boundsOf(walls_[i]);
        entries.emplace_back(boxAround(low, high, margin), static_cast<uint32_t>(i));
    }
    index_ = std::make_unique<const Index>(entries);
}

LineMap::LineMap(LineMap&&) noexcept = default;
LineMap& LineMap::operator=(LineMap&&) noexcept = default;
LineMap::~LineMap() = default;

std::optional<RayHit> LineMap::castRay(const TPoint2D& origin, const TPoint2D& direction,
                                       double maxRange, double z) const {
    // The ray is looked up piece by piece, each longer than the one before: what lies behind the
    // first wall is hardly ever touched, in however large a map. By the box around a piece, which
    // is told from those of the index without divisions; so no piece is so long that the box of a
    // slanting one holds a quarter of a town.
    constexpr double firstPiece = 4.0, longestPiece = 16.0;  // [m]
    std::optional<RayHit> nearest;
    double from = 0, length = firstPiece;
    while (from < maxRange) {
        const double to = std::min(from + length, maxRange);
        const TPoint2D a = origin + direction * from, b = origin + direction * to;
        const Box piece = boxAround({std::min(a.x, b.x), std::min(a.y, b.y)},
                                    {std::max(a.x, b.x), std::max(a.y, b.y)}, 0);
        index_->forEachNear(piece, [&](uint32_t wall) {
            if (!walls_[wall].height.contains(z)) return;
            const auto range = rangeTo(walls_[wall], origin, direction);
            if (!range || *range > maxRange) return;
            // Of walls at one range the first in the map counts, so that the index's order does
            // not.
            if (!nearest || *range < nearest->range ||
                (*range == nearest->range && wall < nearest->wall)) {
                nearest = RayHit{*range, wall, {}};
            }
        });
        if (nearest && nearest->range <= to) break;
        from = to;
        length = std::min(2 * length, longestPiece);
    }
    if (nearest) {
        nearest->incidence =
            incidenceOn(walls_[nearest->wall], direction, origin + direction * nearest->range);
    }
    return nearest;
}

std::optional<NearestWall> LineMap::nearestWall(const TPoint2D& point, double maxDistance,
                                                double z) const {
    std::optional<NearestWall> nearest;
    index_->forEachNear(boxAround(point, point, maxDistance), [&](uint32_t wall) {
        if (!walls_[wall].height.contains(z)) return;
        const double distance = distanceTo(walls_[wall], point);
        if (distance > maxDistance) return;
        if (!nearest || distance < nearest->distance ||
            (distance == nearest->distance && wall < nearest->wall)) {
            nearest = NearestWall{distance, wall};
        }
    });
    return nearest;
}

bool LineMap::hasWallWithin(const TPoint2D& point, double maxDistance) const {
    // Looked for in growing squares: a wall near by is found without touching the rest of the map.
    bool found = false;
    for (double reach = std::min(1.0, maxDistance); !found;
         reach = std::min(4 * reach, maxDistance)) {
        index_->forEachNear(boxAround(point, point, reach), [&](uint32_t wall) {
            found = found || distanceTo(walls_[wall], point) <= maxDistance;
        });
        if (reach >= maxDistance) break;
    }
    return found;
}

}  // namespace offmap::core
