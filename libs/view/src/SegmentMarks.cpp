// SPDX-License-Identifier: BSD-3-Clause
#include "FastCloud.h"
#include "WallStrips.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/view/SegmentMarks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace offmap::view {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::opengl::CRenderizable;
using mrpt::opengl::CSetOfObjects;

/// The vertical plane that a segment stands in.
struct BeamPlane {
    TPoint3D sensor;  ///< [m] map frame
    TPoint2D along;   ///< unit vector on the ground
    double floor;     ///< [m] z in the map that intervals are drawn at

    TPoint3D at(double groundRange, double z) const {
        return {sensor.x + groundRange * along.x, sensor.y + groundRange * along.y, z};
    }
};

/// [m] That marks on the floor are wide, to be seen from where the whole segment is. Lines would
/// not do: many drivers draw them one pixel wide.
double widthAt(double groundRange) { return 0.04 + 0.015 * groundRange; }

void insert(CSetOfObjects& marks, const char* name, const CRenderizable::Ptr& mark) {
    mark->setName(name);
    marks.insert(mark);
}

/// A bar that lies on the floor along the beam. Of triangles, for MRPT draws a CBox without light
/// black. \param aside [m] to the left, of its middle
CRenderizable::Ptr barOf(const core::Interval& interval, const BeamPlane& plane, double aside,
                         double width, const mrpt::img::TColor& colour) {
    const auto from = static_cast<float>(std::max(interval.min(), 0.0));
    const auto to = std::max(static_cast<float>(interval.max()), from);
    const auto left = static_cast<float>(aside + 0.5 * width),
               right = static_cast<float>(aside - 0.5 * width), top = static_cast<float>(width);
    const std::array<mrpt::math::TPoint3Df, 8> corners{{{from, right, 0},
                                                        {to, right, 0},
                                                        {to, left, 0},
                                                        {from, left, 0},
                                                        {from, right, top},
                                                        {to, right, top},
                                                        {to, left, top},
                                                        {from, left, top}}};
    // Its sides and its top; nobody sees it from below.
    constexpr std::array<std::array<size_t, 4>, 5> faces{
        {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};
    auto bar = mrpt::opengl::CSetOfTriangles::Create();
    for (const auto& [a, b, c, d] : faces) {
        bar->insertTriangle(mrpt::opengl::TTriangle(corners[a], corners[b], corners[c]));
        bar->insertTriangle(mrpt::opengl::TTriangle(corners[a], corners[c], corners[d]));
    }
    bar->setPose(mrpt::poses::CPose3D(plane.sensor.x, plane.sensor.y, plane.floor,
                                      std::atan2(plane.along.y, plane.along.x), 0, 0));
    bar->setColor_u8(colour);
    bar->enableLight(false);
    return bar;
}

CRenderizable::Ptr lineOf(const TPoint3D& from, const TPoint3D& to,
                          const mrpt::img::TColor& colour) {
    auto line = mrpt::opengl::CSetOfLines::Create();
    line->appendLine(from, to);
    line->setColor_u8(colour);
    line->setLineWidth(3);
    return line;
}

std::vector<mrpt::math::TPoint3Df> placesOf(const core::OrganizedScan& scan,
                                            const core::VerticalSegment& segment,
                                            const mrpt::poses::CPose3D& sensorInMap) {
    std::vector<mrpt::math::TPoint3Df> places;
    places.reserve(segment.end - segment.begin);
    for (uint32_t i = segment.begin; i < segment.end; ++i) {
        places.emplace_back(sensorInMap.composePoint(scan.points.at(i)));
    }
    return places;
}

/// None if the returns stand right above or below the sensor.
std::optional<BeamPlane> planeThrough(const std::vector<mrpt::math::TPoint3Df>& places,
                                      const mrpt::poses::CPose3D& sensorInMap, double bottom,
                                      const core::Wall* wall) {
    BeamPlane plane{{sensorInMap.x(), sensorInMap.y(), sensorInMap.z()}, {}, 0};
    for (const auto& p : places) {
        plane.along.x += static_cast<double>(p.x) - plane.sensor.x;
        plane.along.y += static_cast<double>(p.y) - plane.sensor.y;
    }
    const double length = plane.along.norm();
    if (!(length > 0 && std::isfinite(length))) return std::nullopt;
    plane.along *= 1 / length;
    plane.floor = plane.sensor.z + bottom;
    if (wall && std::isfinite(wall->height.min())) {
        plane.floor = std::min(plane.floor, wall->height.min());
    }
    return plane;
}

/// A little before the wall, so that both surfaces are not drawn by turns.
core::Wall nearer(core::Wall wall, const BeamPlane& plane) {
    constexpr double before = 0.01;  // [m]
    const TPoint2D foot(plane.sensor.x, plane.sensor.y);
    const TPoint2D shift = core::normalAwayFrom(plane.along, wall, foot) * before;
    wall.line.point1 -= shift;
    wall.line.point2 -= shift;
    return wall;
}

void markWall(CSetOfObjects& marks, const core::Wall& wall, double floor, double top,
              const mrpt::img::TColor& colour) {
    constexpr uint8_t opacity = 110;
    WallStrips strip;
    strip.add(wall, floor, std::isfinite(wall.height.max()) ? wall.height.max() : top);
    auto both = CSetOfObjects::Create();
    both->insert(strip.lines(colour, 3));
    both->insert(strip.surfaces(colour, opacity));
    insert(marks, "wall", both);
}

}  // namespace

CSetOfObjects::Ptr segmentMarksOf(const core::OrganizedScan& scan,
                                  const core::ReductionResult& result, const core::LineMap& map,
                                  uint32_t segment, const Palette& palette,
                                  const std::optional<mrpt::poses::CPose3D>& fallbackSensorInMap) {
    auto marks = CSetOfObjects::Create();
    marks->setName("segment");
    const core::VerticalSegment& found = result.segments.at(segment);
    const core::SegmentMatch& match = result.matches.at(segment);
    const core::ScanColumn& column = scan.columns.at(found.column);
    if (!column.sensor && !fallbackSensorInMap) return marks;
    const auto& sensorInMap = column.sensor ? column.sensor->sensorInMap : *fallbackSensorInMap;
    const core::Wall* wall =
        match.wall && *match.wall < map.walls().size() ? &map.walls()[*match.wall] : nullptr;
    auto places = placesOf(scan, found, sensorInMap);
    const auto plane =
        planeThrough(places, sensorInMap, std::min(found.bottom.y, found.top.y), wall);
    if (!plane) return marks;

    const double width = widthAt(match.measured.centre());
    const double low = plane->sensor.z + found.bottom.y, high = plane->sensor.z + found.top.y;
    std::vector<mrpt::img::TColor> colours(places.size(), palette.highlight);
    const auto cloud = std::make_shared<FastCloud>(std::move(places), std::move(colours));
    cloud->setPointSize(9);
    cloud->enableVariablePointSize(false);
    insert(*marks, "returns", cloud);
    insert(*marks, "line",
           lineOf(plane->at(found.bottom.x, low), plane->at(found.top.x, high), palette.highlight));
    insert(
        *marks, "beam",
        barOf({0, std::max(0.0, match.measured.min())}, *plane, 0, 0.3 * width, palette.highlight));
    insert(*marks, "measured",
           barOf(match.measured, *plane, 0.6 * width, width, palette.highlight));
    if (match.predicted) {
        insert(*marks, "predicted",
               barOf(*match.predicted, *plane, -0.6 * width, width, palette.wall));
    }
    if (wall)
        markWall(*marks, nearer(*wall, *plane), plane->floor, std::max(low, high), palette.wall);
    return marks;
}

}  // namespace offmap::view
