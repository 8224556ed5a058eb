// SPDX-License-Identifier: BSD-3-Clause
#include "CollinearMerge.h"
#include "LineSpecks.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/maps/LineCleaning.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace offmap::maps {

namespace {

/// A wall and where it stood.
struct PlacedWall {
    core::Wall wall;
    size_t place;
};

using Likeness = std::tuple<double, double, double>;

Likeness likenessOf(const core::Wall& wall) {
    return {wall.sigma, wall.height.min(), wall.height.max()};
}

/// Whichever way it was drawn; equal arcs have equal ones, but for the rare pair that a border of
/// the raster divides.
std::array<double, 6> rasterOf(const core::Wall& arc, double raster) {
    auto one = arc.line.point1, other = arc.line.point2;
    if (std::pair(other.x, other.y) < std::pair(one.x, one.y)) std::swap(one, other);
    const auto middle = core::placeAt(arc, 0.5);
    std::array<double, 6> cells{one.x, one.y, other.x, other.y, middle.x, middle.y};
    for (double& cell : cells) cell = std::floor(cell / raster);
    return cells;
}

std::vector<PlacedWall> mergedWalls(const std::vector<PlacedWall>& walls) {
    std::map<Likeness, std::vector<const PlacedWall*>> straight;
    std::set<std::pair<Likeness, std::array<double, 6>>> arcs;
    std::vector<PlacedWall> result;
    for (const PlacedWall& placed : walls) {
        const Likeness likeness = likenessOf(placed.wall);
        const auto raster = [&] {
            return rasterOf(placed.wall, mergeTolerance(placed.wall.sigma));
        };
        if (placed.wall.curvature == 0) {
            straight[likeness].push_back(&placed);
        } else if (arcs.emplace(likeness, raster()).second) {
            result.push_back(placed);
        }
    }
    for (const auto& [likeness, alike] : straight) {
        std::vector<DrawnLine> lines;
        for (const PlacedWall* placed : alike) {
            const auto& line = placed->wall.line;
            lines.emplace_back(line.point1, line.point2, placed->place);
        }
        mergeCollinear(lines, mergeTolerance(std::get<0>(likeness)));
        for (const DrawnLine& line : lines) {
            result.push_back({alike[0]->wall, line.place});
            result.back().wall.line = {line.a, line.b};
        }
    }
    return result;
}

std::vector<PlacedWall> withoutSpecks(const std::vector<PlacedWall>& placed, double minLength) {
    std::vector<core::Wall> walls;
    for (const PlacedWall& each : placed) walls.push_back(each.wall);
    const auto isSpeck = specksAmong(walls, minLength);
    std::vector<PlacedWall> result;
    for (size_t i = 0; i < placed.size(); ++i) {
        if (!isSpeck[i]) result.push_back(placed[i]);
    }
    return result;
}

}  // namespace

double mergeTolerance(double sigma) {
    // A tenth of what a wall is uncertain by anyway; not less than drawings are rounded to, and not
    // so much that a thin board would lose a face.
    return std::clamp(0.1 * sigma, 1e-4, 5e-3);
}

CleanedWalls cleaned(const std::vector<core::Wall>& walls, double minLength) {
    std::vector<PlacedWall> left;
    for (const core::Wall& wall : walls) left.push_back({wall, left.size()});
    CleanedWalls result;
    // What was in the way of a merger may have been a speck.
    for (bool isDone = false; !isDone;) {
        const size_t before = left.size();
        left = mergedWalls(left);
        const size_t merged = left.size();
        left = withoutSpecks(left, minLength);
        result.merged += before - merged;
        result.tooShort += merged - left.size();
        isDone = left.size() == merged;
    }
    std::ranges::sort(left, {}, &PlacedWall::place);
    for (const PlacedWall& placed : left) result.walls.push_back(placed.wall);
    return result;
}

}  // namespace offmap::maps
