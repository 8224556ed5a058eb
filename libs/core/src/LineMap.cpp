// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/LineMap.h>

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

Box boundsOf(const TPoint2D& a, const TPoint2D& b, double margin = 0) {
    return {{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin},
            {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin}};
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
}

/// Ground range at which a ray meets a wall. A ray along the wall meets its nearer end. On which
/// side of the ray an end point lies is worked out from that point alone, so that no ray slips
/// through between two walls that share it.
std::optional<double> rangeTo(const Wall& wall, const TPoint2D& origin, const TPoint2D& direction) {
    const TPoint2D a = wall.line.point1 - origin, b = wall.line.point2 - origin;
    const double leftA = direction.x * a.y - direction.y * a.x;
    const double leftB = direction.x * b.y - direction.y * b.x;
    if ((leftA > 0 && leftB > 0) || (leftA < 0 && leftB < 0)) return std::nullopt;
    const double alongA = direction.x * a.x + direction.y * a.y;
    const double alongB = direction.x * b.x + direction.y * b.y;
    if (leftA == leftB) {  // both 0: the wall lies along the ray
        if (alongA < 0 && alongB < 0) return std::nullopt;
        return std::max(std::min(alongA, alongB), 0.0);
    }
    const double range = alongA + leftA / (leftA - leftB) * (alongB - alongA);
    if (range < 0) return std::nullopt;
    return range;
}

double incidenceOf(const Wall& wall, const TPoint2D& direction) {
    const TPoint2D along = wall.line.point2 - wall.line.point1;
    const double sine = std::abs(direction.x * along.y - direction.y * along.x);
    const double cosine = std::abs(direction.x * along.x + direction.y * along.y);
    return std::max(std::atan2(sine, cosine), std::numeric_limits<double>::min());
}

}  // namespace

LineMap::LineMap(std::vector<Wall> walls) : walls_(std::move(walls)) {
    std::vector<Entry> entries;
    entries.reserve(walls_.size());
    for (size_t i = 0; i < walls_.size(); ++i) {
        requireUsable(walls_[i], i);
        // [m] more than what rounding takes from the look-up, even in coordinates of 1e7 m.
        constexpr double margin = 1e-6;
        entries.emplace_back(boundsOf(walls_[i].line.point1, walls_[i].line.point2, margin),
                             static_cast<uint32_t>(i));
    }
    index_ = std::make_unique<const Index>(entries);
}

LineMap::LineMap(LineMap&&) noexcept = default;
LineMap& LineMap::operator=(LineMap&&) noexcept = default;
LineMap::~LineMap() = default;

std::optional<RayHit> LineMap::castRay(const TPoint2D& origin, const TPoint2D& direction,
                                       double maxRange, double z) const {
    // The ray is looked up piece by piece, each twice as long as the one before: what lies behind
    // the first wall is hardly ever touched, in however large a map.
    constexpr double firstPiece = 4.0;  // [m]
    std::optional<RayHit> nearest;
    double from = 0, to = std::min(firstPiece, maxRange);
    while (from < maxRange) {
        const TPoint2D a = origin + direction * from, b = origin + direction * to;
        const bg::model::segment<Point> piece({a.x, a.y}, {b.x, b.y});
        index_->forEachNear(piece, [&](uint32_t wall) {
            if (!walls_[wall].height.contains(z)) return;
            const auto range = rangeTo(walls_[wall], origin, direction);
            if (!range || *range > maxRange) return;
            // Of walls at one range the first in the map counts, so that the index's order does
            // not.
            if (!nearest || *range < nearest->range ||
                (*range == nearest->range && wall < nearest->wall)) {
                nearest = RayHit{*range, wall, 0};
            }
        });
        if (nearest && nearest->range <= to) break;
        from = to;
        to = std::min(2 * to, maxRange);
    }
    if (nearest) nearest->incidence = incidenceOf(walls_[nearest->wall], direction);
    return nearest;
}

std::optional<NearestWall> LineMap::nearestWall(const TPoint2D& point, double maxDistance,
                                                double z) const {
    const TPoint2D margin(maxDistance, maxDistance);
    std::optional<NearestWall> nearest;
    const Box around = boundsOf(point - margin, point + margin);
    index_->forEachNear(around, [&](uint32_t wall) {
        if (!walls_[wall].height.contains(z)) return;
        const double distance = walls_[wall].line.distance(point);
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
        const TPoint2D margin(reach, reach);
        index_->forEachNear(boundsOf(point - margin, point + margin), [&](uint32_t wall) {
            found = found || walls_[wall].line.distance(point) <= maxDistance;
        });
        if (reach >= maxDistance) break;
    }
    return found;
}

}  // namespace offmap::core
