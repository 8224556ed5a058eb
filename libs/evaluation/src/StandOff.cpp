// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/evaluation/StandOff.h>

#include <boost/geometry.hpp>
#include <mrpt/poses/CPose2D.h>

#include <algorithm>
#include <vector>

namespace offmap::evaluation {

namespace {

namespace bg = boost::geometry;
using mrpt::math::TPoint2D;
using mrpt::math::TSegment2D;
using Point = bg::model::d2::point_xy<double>;
using Segment = bg::model::segment<Point>;

Point boosted(const TPoint2D& point) { return {point.x, point.y}; }
Segment boosted(const TSegment2D& line) { return {boosted(line.point1), boosted(line.point2)}; }

/// What stands for a wall: its line, or many chords of its arc.
std::vector<TSegment2D> chordsOf(const core::Wall& wall) {
    if (wall.curvature == 0) return {wall.line};
    constexpr int count = 256;  // off by 0.4 mm at most, on half a circle of 10 m radius
    std::vector<TSegment2D> chords;
    for (int i = 0; i < count; ++i) {
        chords.emplace_back(core::placeAt(wall, double(i) / count),
                            core::placeAt(wall, double(i + 1) / count));
    }
    return chords;
}

/// A plane reaches everywhere.
double gap(const Plane& /*plane*/, const TSegment2D& /*line*/) { return 0; }

}  // namespace

double gap(const Panel& panel, const TSegment2D& line) {
    return bg::distance(boosted(panel.line), boosted(line));
}

double gap(const Mesh& mesh, const TSegment2D& line) { return gap(mesh.panel, line); }

double gap(const Cylinder& cylinder, const TSegment2D& line) {
    const TPoint2D top = cylinder.centre + cylinder.lean * cylinder.height.width();
    const double fromAxis = bg::distance(boosted(TSegment2D(cylinder.centre, top)), boosted(line));
    return std::max(0.0, fromAxis - cylinder.radius);
}

double gap(const Box& box, const TSegment2D& line) {
    const mrpt::poses::CPose2D centre(box.centre);
    const double x = box.length / 2, y = box.width / 2;
    bg::model::ring<Point> outline;  // clockwise, closed
    for (const TPoint2D& corner :
         {TPoint2D(-x, -y), TPoint2D(-x, y), TPoint2D(x, y), TPoint2D(x, -y), TPoint2D(-x, -y)}) {
        outline.push_back(boosted(TPoint2D(centre.composePoint(corner))));
    }
    return bg::distance(outline, boosted(line));
}

std::optional<double> standOffOf(const World& world, uint32_t surface) {
    const Surface& asked = world.surfaces().at(surface);
    if (asked.kind != SurfaceKind::Object) return std::nullopt;
    std::optional<double> nearest;
    for (const core::Wall& wall : mapOf(world)) {
        for (const TSegment2D& chord : chordsOf(wall)) {
            const double distance =
                std::visit([&](const auto& shape) { return gap(shape, chord); }, asked.shape);
            nearest = std::min(distance, nearest.value_or(distance));
        }
    }
    return nearest;
}

}  // namespace offmap::evaluation
