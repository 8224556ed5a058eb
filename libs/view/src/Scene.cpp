// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/view/Scene.h>

#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CSphere.h>

#include <algorithm>

namespace offmap::view {
namespace {

using mrpt::math::TBoundingBox;
using mrpt::math::TPoint3D;
using mrpt::opengl::CSetOfObjects;

/// Returns off the vertical segments are many and matter least: smaller, and drawn first.
CSetOfObjects::Ptr cloudsOf(const PlacedReturns& returns, const SceneOptions& options) {
    auto rest = mrpt::opengl::CPointCloudColoured::Create();
    auto onSegments = mrpt::opengl::CPointCloudColoured::Create();
    rest->setPointSize(0.7F * options.pointSize);
    onSegments->setPointSize(options.pointSize);
    for (size_t i = 0; i < returns.points.size(); ++i) {
        const core::PointLabel label = returns.labels[i];
        const mrpt::img::TColorf colour(options.palette.of(label));
        const auto& p = returns.points[i];
        auto& cloud = label == core::PointLabel::NotOnVerticalSegment ? *rest : *onSegments;
        cloud.push_back(p.x, p.y, p.z, colour.R, colour.G, colour.B);
    }
    auto clouds = CSetOfObjects::Create();
    clouds->setName("returns");
    clouds->insert(rest);
    clouds->insert(onSegments);
    return clouds;
}

bool comesNear(const mrpt::math::TSegment2D& line, const TBoundingBox& extent) {
    const double margin = 0.25 * std::max(extent.max.x - extent.min.x, extent.max.y - extent.min.y);
    const auto [x1, x2] = std::minmax(line.point1.x, line.point2.x);
    const auto [y1, y2] = std::minmax(line.point1.y, line.point2.y);
    return x1 <= extent.max.x + margin && extent.min.x - margin <= x2 &&
           y1 <= extent.max.y + margin && extent.min.y - margin <= y2;
}

void addWall(const core::Wall& wall, const TBoundingBox& extent, mrpt::opengl::CSetOfLines& lines,
             mrpt::opengl::CSetOfTriangles& surfaces) {
    const double low = std::max(wall.height.min(), extent.min.z);
    const double high = std::max(low, std::min(wall.height.max(), extent.max.z));
    const auto& [a, b] = wall.line;
    const TPoint3D aLow{a.x, a.y, low}, bLow{b.x, b.y, low};
    const TPoint3D aHigh{a.x, a.y, high}, bHigh{b.x, b.y, high};
    lines.appendLine(aLow, bLow);
    lines.appendLine(aHigh, bHigh);
    lines.appendLine(aLow, aHigh);
    lines.appendLine(bLow, bHigh);
    surfaces.insertTriangle(mrpt::opengl::TTriangle(aLow, bLow, bHigh));
    surfaces.insertTriangle(mrpt::opengl::TTriangle(aLow, bHigh, aHigh));
}

CSetOfObjects::Ptr wallsOf(const core::LineMap& map, const TBoundingBox& extent,
                           const SceneOptions& options) {
    auto lines = mrpt::opengl::CSetOfLines::Create();
    auto surfaces = mrpt::opengl::CSetOfTriangles::Create();
    for (const core::Wall& wall : map.walls())
        if (comesNear(wall.line, extent)) addWall(wall, extent, *lines, *surfaces);
    lines->setColor_u8(options.palette.wall);
    lines->setLineWidth(options.wallLineWidth);
    surfaces->setColor_u8(options.palette.wall);
    surfaces->setColorA_u8(options.wallOpacity);
    surfaces->enableLight(false);
    auto walls = CSetOfObjects::Create();
    walls->setName("walls");
    walls->insert(lines);
    if (options.wallOpacity > 0) walls->insert(surfaces);
    return walls;
}

/// A ball where the scanner stood in the middle of the turn, and an arrow to its front.
CSetOfObjects::Ptr sensorOf(const PlacedReturns& returns, const TBoundingBox& extent,
                            const SceneOptions& options) {
    auto sensor = CSetOfObjects::Create();
    sensor->setName("sensor");
    if (returns.sensorPath.empty()) return sensor;
    const auto size = static_cast<float>(
        0.012 * std::max(extent.max.x - extent.min.x, extent.max.y - extent.min.y));
    auto ball = mrpt::opengl::CSphere::Create(size);
    auto arrow =
        mrpt::opengl::CArrow::Create(0, 0, 0, 4 * size, 0, 0, 0.35F, 0.25F * size, 0.7F * size);
    ball->setColor_u8(options.palette.sensor);
    arrow->setColor_u8(options.palette.sensor);
    arrow->enableLight(false);
    sensor->insert(ball);
    sensor->insert(arrow);
    sensor->setPose(returns.sensorPath[returns.sensorPath.size() / 2]);
    return sensor;
}

}  // namespace

mrpt::img::TColor Palette::of(core::PointLabel label) const {
    switch (label) {
        case core::PointLabel::Mapped:
            return mapped;
        case core::PointLabel::Kept:
            return kept;
        case core::PointLabel::Orphan:
            return orphan;
        case core::PointLabel::NotOnVerticalSegment:
            break;
    }
    return rest;
}

CSetOfObjects::Ptr sceneOf(const PlacedReturns& returns, const core::LineMap& map,
                           const TBoundingBox& extent, const SceneOptions& options) {
    auto scene = CSetOfObjects::Create();
    scene->insert(cloudsOf(returns, options));
    scene->insert(sensorOf(returns, extent, options));
    scene->insert(wallsOf(map, extent, options));  // last: it lets the others shine through
    return scene;
}

}  // namespace offmap::view
