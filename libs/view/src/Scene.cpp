// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/view/Scene.h>

#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CSphere.h>

#include <algorithm>
#include <cmath>

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
        const mrpt::img::TColorf colour(returns.colours.empty() ? options.palette.of(label)
                                                                : returns.colours[i]);
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

bool comesNear(const core::Wall& wall, const TBoundingBox& extent) {
    const double margin = 0.25 * std::max(extent.max.x - extent.min.x, extent.max.y - extent.min.y);
    const auto [low, high] = core::boundsOf(wall);
    return low.x <= extent.max.x + margin && extent.min.x - margin <= high.x &&
           low.y <= extent.max.y + margin && extent.min.y - margin <= high.y;
}

/// How many straight pieces look like the wall.
int piecesOf(const core::Wall& wall) {
    constexpr double angle = 0.1;  // [rad] of a piece that looks straight
    const double turn = std::abs(wall.curvature) * core::lengthOf(wall);
    return std::max(1, static_cast<int>(std::ceil(turn / angle)));
}

void addWall(const core::Wall& wall, const TBoundingBox& extent, mrpt::opengl::CSetOfLines& lines,
             mrpt::opengl::CSetOfTriangles& surfaces) {
    const double low = std::max(wall.height.min(), extent.min.z);
    const double high = std::max(low, std::min(wall.height.max(), extent.max.z));
    const auto at = [](const mrpt::math::TPoint2D& p, double z) { return TPoint3D{p.x, p.y, z}; };
    const int pieces = piecesOf(wall);
    mrpt::math::TPoint2D a = wall.line.point1;
    lines.appendLine(at(a, low), at(a, high));
    for (int i = 1; i <= pieces; ++i) {
        const auto b = i == pieces ? wall.line.point2 : core::placeAt(wall, double(i) / pieces);
        lines.appendLine(at(a, low), at(b, low));
        lines.appendLine(at(a, high), at(b, high));
        surfaces.insertTriangle(mrpt::opengl::TTriangle(at(a, low), at(b, low), at(b, high)));
        surfaces.insertTriangle(mrpt::opengl::TTriangle(at(a, low), at(b, high), at(a, high)));
        a = b;
    }
    lines.appendLine(at(a, low), at(a, high));
}

CSetOfObjects::Ptr wallsOf(const core::LineMap& map, const TBoundingBox& extent,
                           const SceneOptions& options) {
    auto lines = mrpt::opengl::CSetOfLines::Create();
    auto surfaces = mrpt::opengl::CSetOfTriangles::Create();
    for (const core::Wall& wall : map.walls())
        if (comesNear(wall, extent)) addWall(wall, extent, *lines, *surfaces);
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

CSetOfObjects::Ptr sceneOf(const PlacedReturns& returns, const core::LineMap& map,
                           const TBoundingBox& extent, const SceneOptions& options) {
    auto scene = CSetOfObjects::Create();
    scene->insert(cloudsOf(returns, options));
    scene->insert(sensorOf(returns, extent, options));
    scene->insert(wallsOf(map, extent, options));  // last: it lets the others shine through
    return scene;
}

}  // namespace offmap::view
